#include "map_matcher/ros/matching/match_pose_publisher.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/console.h>

#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/common/stamps.hpp"
#include "map_matcher/ros/matching/match_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr double kWarningPeriod = 30.0;  // [s]

/// `match` with the robot there.
geometry_msgs::PoseWithCovarianceStamped poseMessage(const MapMatch& match, const grid::Rigid2& T_session_base) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = match.reference_frame;
  message.header.stamp = match.session_stamp;
  message.pose = robotPose(match, T_session_base);
  return message;
}

}  // namespace

MatchPosePublisher::MatchPosePublisher(ros::NodeHandle node, const RobotPoseSource& robot)
    : robot_(robot),
      publisher_(node.advertise<geometry_msgs::PoseWithCovarianceStamped>(ros_common::names::kMatchPose, 1, true)) {}

void MatchPosePublisher::request(const MapMatch& match, const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  pending_ = Pending{match, now};
}

void MatchPosePublisher::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  pending_.reset();
}

void MatchPosePublisher::publishPending(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!pending_) {
    return;
  }
  const MapMatch& match = pending_->match;
  const RobotPose robot = robot_.at(match.session_frame, match.session_stamp);
  if (robot.T_session_base) {
    publisher_.publish(poseMessage(match, *robot.T_session_base));
    pending_.reset();
  } else if (ros_common::secondsBetween(pending_->since, now) > kPatience) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "match_pose is not sent: " << robot.reason);
    pending_.reset();
  }
}

}  // namespace map_matcher::ros_matching
