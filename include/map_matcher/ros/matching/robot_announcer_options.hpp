/// \file
/// What can be chosen about how the robot's place is told.
#pragma once

#include <string>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::ros_matching {

/// Options of a RobotAnnouncer. Their ranges stand in parametersOf().
struct RobotAnnouncerOptions {
  double robot_pose_rate = 10.0;     ///< [Hz] robot_pose in a second; 0: never.
  bool publish_initialpose = false;  ///< Whether initialpose is sent, once for each time that the robot was found.
  std::string fix_file;              ///< File that the robot's last place is kept in; empty: none.
};

/// The parameters that fill `options`, by the names they have in config/map_matcher.yaml.
parameters::ParameterList parametersOf(RobotAnnouncerOptions& options);

}  // namespace map_matcher::ros_matching
