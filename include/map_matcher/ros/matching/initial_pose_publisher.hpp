/// \file
/// The first pose for a node that follows the robot from there on.
#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <optional>

#include "map_matcher/ros/matching/fix.hpp"
#include "map_matcher/ros/matching/robot_pose_source.hpp"

namespace map_matcher::ros_matching {

/// Sends `initialpose`, for amcl, once each time the robot was found: where it was in the reference map at the stamp of
/// the session map. With that stamp amcl moves the pose on by the odometry since then. Found again after it was lost,
/// or elsewhere, it is sent once more. It waits for somebody to listen, and is then the pose of the newest match: an
/// old one would be a wrong one. Thread-safe.
class InitialPosePublisher {
 public:
  /// A place farther from that of the match before is another one: where the robot would have jumped to on tf.
  static constexpr double kDistinctDistance = 1.0;  ///< [m]
  static constexpr double kDistinctAngle = 0.2;     ///< [rad]

  /// Sends nothing at all unless `enabled`. `robot` must outlive this. The node itself listens to `initialpose`, too.
  InitialPosePublisher(ros::NodeHandle node, const RobotPoseSource& robot, bool enabled);

  /// The match in use from now on.
  void set(const Fix& fix);

  /// There is no match in use any more: the next one is a new beginning.
  void clear();

  /// Sends the pose that is due if tf allows and somebody listens; to be called again and again.
  void publishPending();

 private:
  bool isElsewhere(const Fix& fix) const;

  const RobotPoseSource& robot_;
  const bool enabled_;
  std::mutex mutex_;            // guards both below
  std::optional<Fix> pending_;  // to be sent
  std::optional<Fix> sent_;     // the newest one at the place that was sent
  ros::Publisher publisher_;
};

}  // namespace map_matcher::ros_matching
