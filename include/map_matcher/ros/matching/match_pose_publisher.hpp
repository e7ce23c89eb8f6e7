/// \file
/// The robot's pose in the reference map, for nodes that want a pose rather than tf.
#pragma once

#include <map_matcher/MapMatch.h>
#include <ros/node_handle.h>

#include <mutex>
#include <optional>

#include "map_matcher/ros/matching/robot_pose_source.hpp"

namespace map_matcher::ros_matching {

/// Publishes, for each accepted match, where the robot was in the reference map at the stamp of the session map. That
/// is known only when tf says where it was in the session map: a pose waits for it, never blocks, and is given up after
/// kPatience. Thread-safe.
class MatchPosePublisher {
 public:
  /// How long a pose waits for tf [s].
  static constexpr double kPatience = 1.0;

  /// `robot` must outlive this.
  MatchPosePublisher(ros::NodeHandle node, const RobotPoseSource& robot);

  /// Publishes the pose of this match as soon as tf allows, instead of one that still waits. Its status is MATCHED.
  void request(const MapMatch& match, const ros::Time& now);

  /// Forgets a pose that waits.
  void clear();

  /// Publishes the pose that waits if tf allows; to be called again and again.
  void publishPending(const ros::Time& now);

 private:
  struct Pending {
    MapMatch match;
    ros::Time since;
  };

  const RobotPoseSource& robot_;
  std::mutex mutex_;  // guards pending_
  std::optional<Pending> pending_;
  ros::Publisher publisher_;
};

}  // namespace map_matcher::ros_matching
