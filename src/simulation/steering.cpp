#include "map_matcher/simulation/steering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace map_matcher {
namespace {

constexpr double kReaction = 0.5;             // [s] that remain to a collision at least
constexpr double kShortestView = 0.6;         // [m] ways are compared over this length at least
constexpr double kLongestView = 2.5;          // [m] ways are compared over this length at most
constexpr double kTurn = M_PI / 12.0;         // [rad] between two headings that are compared
constexpr int kTurns = 5;                     // headings on either side
constexpr double kWallStep = 0.1;             // [m] between the places that are tested near walls
constexpr double kSurelyClear = 0.05;         // [m] more clearance than needed, so that the exact test is not
constexpr double kTouchingTurn = 0.5;         // cosine of the angle from somebody who is touched at which one gets past
constexpr double kLowestClosingSpeed = 0.01;  // [m/s] who approach slower do not meet

/// How far somebody can go along a heading before touching a wall [m].
double freeOfWalls(const World& world, const Mover& self, const Eigen::Vector2d& heading, double view) {
  double travelled = 0.0;
  while (travelled < view) {
    const Eigen::Vector2d place = self.position + heading * travelled;
    const double spare = world.clearance(place) - self.radius;
    if (spare < kSurelyClear && travelled > 0.0 && !world.isClear(place, self.radius)) {
      return std::max(0.0, travelled - kWallStep);
    }
    travelled += std::max(spare, kWallStep);
  }
  return view;
}

/// How far somebody comes with this velocity before touching another [m].
double freeOf(const Mover& other, const Mover& self, const Eigen::Vector2d& velocity) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d offset = other.position - self.position;
  const Eigen::Vector2d closing = velocity - other.velocity;
  const double reach = self.radius + other.radius;
  const double approach = offset.dot(closing);
  if (approach <= 0.0 || closing.norm() < kLowestClosingSpeed) {
    return kNever;
  }
  const double gap = offset.squaredNorm() - reach * reach;
  if (gap <= 0.0) {
    return approach > kTouchingTurn * offset.norm() * closing.norm() ? 0.0 : kNever;
  }
  // |offset - closing * t| = reach
  const double discriminant = approach * approach - closing.squaredNorm() * gap;
  if (discriminant < 0.0) {
    return kNever;
  }
  const double time = (approach - std::sqrt(discriminant)) / closing.squaredNorm();
  return time * velocity.norm();
}

}  // namespace

Eigen::Vector2d steer(const World& world, const Mover& self, const Eigen::Vector2d& target, double speed,
                      const std::vector<Mover>& others) {
  const Eigen::Vector2d to_target = target - self.position;
  const double view = std::clamp(to_target.norm(), kShortestView, kLongestView);
  const double straight = std::atan2(to_target.y(), to_target.x());
  double best_cost = std::numeric_limits<double>::infinity();
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  // Straight on, then right, left, farther right, farther left.
  for (int i = 0; i <= 2 * kTurns; ++i) {
    const int steps = (i + 1) / 2;  // 0, 1, 1, 2, 2, ...
    const double turn = kTurn * steps * (i % 2 == 0 ? 1.0 : -1.0);
    const Eigen::Vector2d heading(std::cos(straight + turn), std::sin(straight + turn));
    double free = freeOfWalls(world, self, heading, view);
    for (const Mover& other : others) {
      free = std::min(free, freeOf(other, self, heading * speed));
    }
    const double used = std::min(free, view * std::cos(turn));  // to where the way comes nearest to the target
    const double cost = view * view + used * used - 2.0 * view * used * std::cos(turn);
    if (cost < best_cost - 1e-9) {
      best_cost = cost;
      best = heading * std::min(speed, free / kReaction);
    }
    if (i == 0 && free >= view) {
      break;  // nothing is better than the straight way
    }
  }
  return best;
}

}  // namespace map_matcher
