#include "map_matcher/ros/matching/match_pose_publisher.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/console.h>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/matching/match_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr double kWarningPeriod = 30.0;  // [s]

/// `match` with the robot at `session_to_base` of tf. Throws MessageError when that is no pose of the plane.
geometry_msgs::PoseWithCovarianceStamped poseMessage(const MapMatch& match,
                                                     const geometry_msgs::TransformStamped& session_to_base) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = match.reference_frame;
  message.header.stamp = session_to_base.header.stamp;
  message.pose = robotPose(match, ros_common::fromMessage(session_to_base.transform, "the robot's pose on tf"));
  return message;
}

}  // namespace

MatchPosePublisher::MatchPosePublisher(ros::NodeHandle node, const std::string& base_frame)
    : base_frame_(base_frame),
      publisher_(node.advertise<geometry_msgs::PoseWithCovarianceStamped>(ros_common::names::kMatchPose, 1, true)) {}

void MatchPosePublisher::request(const MapMatch& match, const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  pending_ = Pending{match, now};
}

void MatchPosePublisher::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  pending_.reset();
}

std::optional<grid::Rigid2> MatchPosePublisher::newestPose(const std::string& session_frame) const {
  try {
    return ros_common::fromMessage(buffer_.lookupTransform(session_frame, base_frame_, ros::Time()).transform,
                                   "the robot's pose on tf");
  } catch (const std::exception&) {  // tf2::TransformException or MessageError
    return std::nullopt;
  }
}

void MatchPosePublisher::publishPending(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!pending_) {
    return;
  }
  const MapMatch& match = pending_->match;
  try {
    const auto session_to_base = buffer_.lookupTransform(match.session_frame, base_frame_, match.session_stamp);
    publisher_.publish(poseMessage(match, session_to_base));
    pending_.reset();
  } catch (const std::exception& error) {  // tf2::TransformException or MessageError
    if ((now - pending_->since).toSec() > kPatience) {
      ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "match_pose is not sent: " << error.what());
      pending_.reset();
    }
  }
}

}  // namespace map_matcher::ros_matching
