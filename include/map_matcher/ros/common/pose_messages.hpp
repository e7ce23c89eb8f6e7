/// \file
/// Poses of the plane with their covariance as messages.
#pragma once

#include <geometry_msgs/PoseWithCovariance.h>

#include <Eigen/Core>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::ros_common {

/// The pose with the covariance of its (x, y, yaw). z, roll and pitch, which are zero in a plane, have none.
geometry_msgs::PoseWithCovariance toMessage(const grid::Rigid2& pose, const Eigen::Matrix3d& covariance);

/// The covariance of (x, y, yaw) in a message; not checked.
Eigen::Matrix3d planarCovariance(const geometry_msgs::PoseWithCovariance& message);

}  // namespace map_matcher::ros_common
