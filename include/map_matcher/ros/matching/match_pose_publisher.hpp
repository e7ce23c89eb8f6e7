/// \file
/// The robot's pose in the reference map, for nodes that want a pose rather than tf.
#pragma once

#include <map_matcher/MapMatch.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <mutex>
#include <optional>
#include <string>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::ros_matching {

/// Publishes, for each accepted match, where the robot was in the reference map at the stamp of the session map. That
/// is known only when tf says where it was in the session map: a pose waits for it, never blocks, and is given up after
/// kPatience. Thread-safe.
class MatchPosePublisher {
 public:
  /// How long a pose waits for tf [s].
  static constexpr double kPatience = 1.0;

  MatchPosePublisher(ros::NodeHandle node, const std::string& base_frame);

  /// Publishes the pose of this match as soon as tf allows, instead of one that still waits. Its status is MATCHED.
  void request(const MapMatch& match, const ros::Time& now);

  /// Forgets a pose that waits.
  void clear();

  /// T_session_base by the newest transforms on tf; nothing when tf does not know it.
  std::optional<grid::Rigid2> newestPose(const std::string& session_frame) const;

  /// Publishes the pose that waits if tf allows; to be called again and again.
  void publishPending(const ros::Time& now);

 private:
  struct Pending {
    MapMatch match;
    ros::Time since;
  };

  const std::string base_frame_;
  std::mutex mutex_;  // guards pending_
  std::optional<Pending> pending_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
  ros::Publisher publisher_;
};

}  // namespace map_matcher::ros_matching
