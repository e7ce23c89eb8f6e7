/// \file
/// An accepted match, for those who tell of the robot.
#pragma once

#include <ros/time.h>

#include <Eigen/Core>
#include <string>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/ros/matching/reference_map.hpp"

namespace map_matcher::ros_matching {

/// How a session map lies in a reference map.
struct Fix {
  ReferenceMapPtr reference;                             ///< Not null.
  std::string session_frame;                             ///< Without a leading slash.
  ros::Time stamp;                                       ///< Of the session map.
  grid::Rigid2 T_reference_session;                      ///< p_reference = T_reference_session * p_session.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< Of (x, y, yaw) of it [m, m, rad].
};

}  // namespace map_matcher::ros_matching
