/// \file
/// All that is told of the robot besides tf.
#pragma once

#include <ros/node_handle.h>

#include <optional>

#include "map_matcher/ros/matching/fix_keeper.hpp"
#include "map_matcher/ros/matching/initial_pose_publisher.hpp"
#include "map_matcher/ros/matching/robot_announcer_options.hpp"
#include "map_matcher/ros/matching/robot_locator.hpp"
#include "map_matcher/ros/matching/robot_pose_publisher.hpp"

namespace map_matcher::ros_matching {

/// Tells other nodes, and the next start of this one, where the robot is: robot_pose, initialpose and the fix file.
/// set() and clear() may be called on any thread.
class RobotAnnouncer {
 public:
  /// `robot` must outlive this.
  RobotAnnouncer(const ros::NodeHandle& node, const RobotPoseSource& robot, const RobotAnnouncerOptions& options);

  /// The match in use from now on.
  void set(const Fix& fix);

  /// There is no match in use any more.
  void clear();

  /// Sends and saves what is due; to be called again and again. Returns where the last run of the node says that the
  /// session lies, once, when that is known.
  std::optional<belief::Prior> tick(const MapsLookup& maps, const ros::Time& now);

 private:
  RobotLocator locator_;
  RobotPosePublisher pose_publisher_;
  InitialPosePublisher initial_pose_publisher_;
  FixKeeper keeper_;
};

}  // namespace map_matcher::ros_matching
