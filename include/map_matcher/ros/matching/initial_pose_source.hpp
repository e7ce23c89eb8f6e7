/// \file
/// Where an operator says that the robot is.
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>

#include "map_matcher/belief/prior.hpp"
#include "map_matcher/ros/matching/reference_map.hpp"
#include "map_matcher/ros/matching/robot_pose_source.hpp"

namespace map_matcher::ros_matching {

/// The maps in use.
struct MapsInUse {
  ReferenceMapList references;  ///< Empty: none yet.
  std::string session_frame;    ///< Empty: no session map yet.
};

/// Looks up the maps in use, which may wait for somebody who changes them.
using MapsLookup = std::function<MapsInUse()>;

/// What is wrong with a pose that is said to be the robot's in one of `references`, with the value and what was
/// expected;
/// "" when it can be used.
std::string problemWithInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message,
                                   const ReferenceMapList& references);

/// Takes poses of the robot in the reference map from `initialpose`, as rviz's tool sends them, and makes of each where
/// the session lies, as soon as tf says where the robot was in the session map at the pose's stamp. What cannot be used
/// is told and ignored. What this node sends on that topic is not listened to. For one thread.
class InitialPoseSource {
 public:
  /// How long a pose waits for tf [s].
  static constexpr double kPatience = 1.0;

  using Listener = std::function<void(const belief::Prior&)>;

  /// `robot` must outlive this.
  InitialPoseSource(ros::NodeHandle node, const RobotPoseSource& robot, MapsLookup maps, Listener listener);

  /// Hands over a pose that waits if tf allows; to be called again and again.
  void handOver(const ros::Time& now);

 private:
  using PoseEvent = ros::MessageEvent<const geometry_msgs::PoseWithCovarianceStamped>;
  struct Pending {
    geometry_msgs::PoseWithCovarianceStampedConstPtr message;
    std::string publisher;
    ros::Time since;
  };

  void onPose(const PoseEvent& event);
  std::string problem() const;
  void ignore(const std::string& why);

  const RobotPoseSource& robot_;
  MapsLookup maps_;
  Listener listener_;
  std::optional<Pending> pending_;
  ros::Subscriber subscriber_;
};

}  // namespace map_matcher::ros_matching
