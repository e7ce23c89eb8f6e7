/// \file
/// How a pedestrian gets past walls and other people.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// Somebody or something round that moves over the floor.
struct Mover {
  Eigen::Vector2d position;  ///< Of its centre in the map frame [m].
  Eigen::Vector2d velocity;  ///< [m/s]
  double radius = 0.0;       ///< [m]
};

/// The velocity that a pedestrian wants who goes towards `target` [m] at `speed` [m/s] when nothing is in the way. Two
/// rules (Moussaid, Helbing, Theraulaz: "How simple rules determine pedestrian behavior and crowd disasters", 2011): of
/// the headings within 75 degrees, go along the one whose unobstructed way comes nearest to the target, when everybody
/// keeps their velocity; and go only so fast that half a second remains to the first collision. Of two headings that
/// are equally good the right one is taken, so that people who meet evade each other.
Eigen::Vector2d steer(const World& world, const Mover& self, const Eigen::Vector2d& target, double speed,
                      const std::vector<Mover>& others);

}  // namespace map_matcher::simulation
