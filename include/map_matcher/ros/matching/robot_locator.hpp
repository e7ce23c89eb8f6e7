/// \file
/// Where the robot is in the reference map, at any time.
#pragma once

#include <ros/time.h>

#include <mutex>
#include <optional>

#include "map_matcher/fixes/dead_reckoning.hpp"
#include "map_matcher/ros/matching/fix.hpp"
#include "map_matcher/ros/matching/robot_pose_source.hpp"

namespace map_matcher::ros_matching {

/// The robot in a reference map.
struct LocatedRobot {
  ReferenceMapPtr reference;
  fixes::PoseEstimate pose;
  ros::Time stamp;  ///< Of the pose.
};

/// Puts together how the session lies in the reference map and where tf has the robot in the session. Thread-safe.
class RobotLocator {
 public:
  /// `robot` must outlive this.
  explicit RobotLocator(const RobotPoseSource& robot) : robot_(robot) {}

  /// The match in use from now on.
  void set(const Fix& fix);

  /// There is no match in use any more.
  void clear();

  /// The robot now, or up to RobotPoseSource::kMaxAge ago; nothing when that is not known.
  std::optional<LocatedRobot> locate(const ros::Time& now);

 private:
  void beginReckoning(const RobotPose& now);

  const RobotPoseSource& robot_;
  std::mutex mutex_;  // guards all below
  std::optional<Fix> fix_;
  std::optional<fixes::DeadReckoning> reckoning_;  // nothing before tf has known the robot since the fix
};

}  // namespace map_matcher::ros_matching
