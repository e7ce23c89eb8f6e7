/// \file
/// A circle on the floor.
#pragma once

#include <Eigen/Core>

namespace map_matcher::simulation {

/// A round obstacle, such as a leg.
struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< [m]
  double radius = 0.0;                               ///< [m]
};

}  // namespace map_matcher::simulation
