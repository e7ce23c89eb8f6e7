/// \file
/// steer() as its rules read, without what saves it work: every heading, everybody, every wall.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "map_matcher/simulation/steering.hpp"

namespace map_matcher::test {

/// Way [m] along a heading to the first place near a wall, at most `view`.
inline double wayToWall(const simulation::World& world, const simulation::Mover& self, const Eigen::Vector2d& heading,
                        double view) {
  double way = 0.0;
  while (way < view) {
    const Eigen::Vector2d place = self.position + heading * way;
    const double spare = world.clearance(place) - self.radius;
    if (spare < 0.05 && way > 0.0 && !world.isClear(place, self.radius)) {
      return std::max(0.0, way - 0.1);
    }
    way += std::max(spare, 0.1);
  }
  return view;
}

/// Way [m] at a velocity to where the two touch; infinity when they do not.
inline double wayToTouch(const simulation::Mover& other, const simulation::Mover& self,
                         const Eigen::Vector2d& velocity) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d offset = other.position - self.position;
  const Eigen::Vector2d closing = velocity - other.velocity;
  const double approach = offset.dot(closing);
  const double gap = offset.squaredNorm() - std::pow(self.radius + other.radius, 2);
  if (approach <= 0.0 || closing.norm() < 0.01) {
    return kNever;
  }
  if (gap <= 0.0) {
    return approach > 0.5 * offset.norm() * closing.norm() ? 0.0 : kNever;
  }
  const double discriminant = approach * approach - closing.squaredNorm() * gap;
  return discriminant < 0.0 ? kNever : (approach - std::sqrt(discriminant)) / closing.squaredNorm() * velocity.norm();
}

inline Eigen::Vector2d steerByTheRules(const simulation::World& world, const simulation::Mover& self,
                                       const Eigen::Vector2d& target, double speed,
                                       const std::vector<simulation::Mover>& others) {
  const Eigen::Vector2d to_target = target - self.position;
  const double view = std::clamp(to_target.norm(), 0.6, 2.5);
  double best_cost = std::numeric_limits<double>::infinity();
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  for (const int steps : {0, -1, 1, -2, 2, -3, 3, -4, 4, -5, 5}) {
    const double turn = M_PI / 12.0 * steps;
    const double angle = std::atan2(to_target.y(), to_target.x()) + turn;
    const Eigen::Vector2d heading(std::cos(angle), std::sin(angle));
    double free = wayToWall(world, self, heading, view);
    for (const simulation::Mover& other : others) {
      free = std::min(free, wayToTouch(other, self, heading * speed));
    }
    const double used = std::min(free, view * std::cos(turn));
    const double cost = view * view + used * used - 2.0 * view * used * std::cos(turn);
    if (cost < best_cost - 1e-9) {
      best_cost = cost;
      best = heading * std::min(speed, free / 0.5);
    }
  }
  return best;
}

}  // namespace map_matcher::test
