#include "map_matcher/simulation/steering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace map_matcher::simulation {
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
constexpr double kRounding = 1e-9;            // [m] or [m^2] that distances and costs may be off

/// Somebody else, as seen from who steers.
struct Encounter {
  Eigen::Vector2d offset;    // of the other [m]
  Eigen::Vector2d velocity;  // of the other [m/s]
  double reach;              // [m] between the centres when both touch
  double soonest;            // [m] come before they touch, at least, whatever the heading
};

/// How far somebody can go along a heading before touching a wall [m]. What is `enough` or more may come out as any
/// such distance.
double freeOfWalls(const World& world, const Mover& self, const Eigen::Vector2d& heading, double view, double enough) {
  const double end = std::min(view, enough + kWallStep + kRounding);
  double travelled = 0.0;
  while (travelled < end) {
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
double freeOf(const Encounter& other, const Eigen::Vector2d& velocity) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d closing = velocity - other.velocity;
  const double approach = other.offset.dot(closing);
  if (approach <= 0.0 || closing.norm() < kLowestClosingSpeed) {
    return kNever;
  }
  const double gap = other.offset.squaredNorm() - other.reach * other.reach;
  if (gap <= 0.0) {
    return approach > kTouchingTurn * other.offset.norm() * closing.norm() ? 0.0 : kNever;
  }
  // |offset - closing * t| = reach
  const double discriminant = approach * approach - closing.squaredNorm() * gap;
  if (discriminant < 0.0) {
    return kNever;
  }
  const double time = (approach - std::sqrt(discriminant)) / closing.squaredNorm();
  return time * velocity.norm();
}

/// Those others who can be touched within `view` [m], the soonest first: in a crowd the first few end a way, and the
/// others need not be looked at.
std::vector<Encounter> encounters(const Mover& self, double speed, double view, const std::vector<Mover>& others) {
  std::vector<Encounter> met;
  met.reserve(others.size());
  for (const Mover& other : others) {
    const Eigen::Vector2d offset = other.position - self.position;
    const double reach = self.radius + other.radius;
    const double closing = speed + other.velocity.norm();
    const double gap = std::max(0.0, offset.norm() - reach);
    const double soonest = (closing > 0.0 ? gap * speed / closing : 0.0) - kRounding;
    if (soonest < view) {
      met.push_back({offset, other.velocity, reach, soonest});
    }
  }
  std::sort(met.begin(), met.end(), [](const Encounter& a, const Encounter& b) { return a.soonest < b.soonest; });
  return met;
}

/// How far somebody comes with this velocity before touching anything, or `view` [m].
double freeWay(const World& world, const Mover& self, const std::vector<Encounter>& met, const Eigen::Vector2d& heading,
               double speed, double view) {
  double free = view;
  for (const Encounter& other : met) {
    if (other.soonest >= free) {
      break;
    }
    free = std::min(free, freeOf(other, heading * speed));
  }
  return free > 0.0 ? std::min(free, freeOfWalls(world, self, heading, view, free)) : free;
}

/// Squared distance [m^2] from the end of a way to a target in `view` [m] that lies `turn` [rad] off it.
double costOf(double free, double view, double turn) {
  const double used = std::min(free, view * std::cos(turn));  // to where the way comes nearest to the target
  return view * view + used * used - 2.0 * view * used * std::cos(turn);
}

}  // namespace

Eigen::Vector2d steer(const World& world, const Mover& self, const Eigen::Vector2d& target, double speed,
                      const std::vector<Mover>& others) {
  const Eigen::Vector2d to_target = target - self.position;
  const double view = std::clamp(to_target.norm(), kShortestView, kLongestView);
  const double straight = std::atan2(to_target.y(), to_target.x());
  const std::vector<Encounter> met = encounters(self, speed, view, others);
  double best_cost = std::numeric_limits<double>::infinity();
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  // Straight on, then right, left, farther right, farther left.
  for (int i = 0; i <= 2 * kTurns; ++i) {
    const int steps = (i + 1) / 2;  // 0, 1, 1, 2, 2, ...
    const double turn = kTurn * steps * (i % 2 == 0 ? 1.0 : -1.0);
    if (costOf(view, view, turn) >= best_cost) {
      break;  // nor is any farther turn better, however free
    }
    const Eigen::Vector2d heading(std::cos(straight + turn), std::sin(straight + turn));
    const double free = freeWay(world, self, met, heading, speed, view);
    const double cost = costOf(free, view, turn);
    if (cost < best_cost - kRounding) {
      best_cost = cost;
      best = heading * std::min(speed, free / kReaction);
    }
    if (i == 0 && free >= view) {
      break;  // nothing is better than the straight way
    }
  }
  return best;
}

}  // namespace map_matcher::simulation
