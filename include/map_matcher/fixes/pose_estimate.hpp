/// \file
/// Where the robot is in the reference map, and how well that is known.
#pragma once

#include <Eigen/Core>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::fixes {

/// The robot in the reference map.
struct PoseEstimate {
  grid::Rigid2 T_reference_base;                         ///< The robot's pose.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< Of (x, y, yaw) of it [m, m, rad].
  double stamp = 0.0;                                    ///< When it was there [s].
};

}  // namespace map_matcher::fixes
