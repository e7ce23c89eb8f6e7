/// \file
/// The robot's pose in the reference map, all the time.
#pragma once

#include <ros/node_handle.h>

#include "map_matcher/ros/matching/robot_locator.hpp"

namespace map_matcher::ros_matching {

/// Publishes, on `robot_pose`, where the robot is in the reference map, as often as is asked for and as tf knows
/// something new; nothing while there is no match in use.
class RobotPosePublisher {
 public:
  /// `rate` [Hz]; 0: never. `locator` must outlive this.
  RobotPosePublisher(ros::NodeHandle node, RobotLocator& locator, double rate);

 private:
  void publish();

  RobotLocator& locator_;
  ros::Time last_;  // stamp of the last pose
  ros::Publisher publisher_;
  ros::Timer timer_;
};

}  // namespace map_matcher::ros_matching
