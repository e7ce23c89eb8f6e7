/// \file
/// Where the robot is in the session map, by tf.
#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::ros_matching {

/// Where the robot was, or why that is not known.
struct RobotPose {
  std::optional<grid::Rigid2> T_session_base;  ///< Projected to the plane, however the robot is tilted.
  ros::Time stamp;                             ///< Of that pose.
  std::string reason;                          ///< Why there is none, for people; empty when there is one.
};

/// Asks tf for the robot's pose in session maps. As thread-safe as its buffer.
class RobotPoseSource {
 public:
  /// How much older than a session map the robot's pose may be [s]. The odometry's transforms arrive some tenths of a
  /// second after the scans of the same time; a robot drives 0.5 m in 0.5 s at most.
  static constexpr double kMaxAge = 0.5;

  /// `tf` must outlive this; `base_frame` is the robot's.
  RobotPoseSource(const tf2::BufferCore& tf, const std::string& base_frame);

  /// The robot's pose in `session_frame` at the stamp of a session map, as tf interpolates it.
  RobotPose at(const std::string& session_frame, const ros::Time& stamp) const;

  /// The same; when tf does not reach to the stamp yet, the newest pose, if it is at most kMaxAge older.
  RobotPose atOrShortlyBefore(const std::string& session_frame, const ros::Time& stamp) const;

  /// The robot's frame and those above it at present, upwards. With two parents of one of them tf jumps between both.
  std::vector<std::string> framesUpwards() const;

 private:
  RobotPose lookUp(const std::string& session_frame, const ros::Time& stamp) const;
  RobotPose unknown(const std::string& session_frame, const ros::Time& stamp, double max_age) const;

  const tf2::BufferCore& tf_;
  const std::string base_frame_;
};

}  // namespace map_matcher::ros_matching
