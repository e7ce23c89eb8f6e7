#include "map_matcher/ros/matching/initial_pose_publisher.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/console.h>

#include <cmath>
#include <utility>

#include "map_matcher/grid/pose_covariance.hpp"
#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/common/pose_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr std::uint32_t kOwnSubscribers = 1;

geometry_msgs::PoseWithCovarianceStamped messageOf(const Fix& fix, const grid::Rigid2& T_session_base) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = fix.reference->frame;
  message.header.stamp = fix.stamp;
  message.pose =
      ros_common::toMessage(fix.T_reference_session * T_session_base,
                            grid::covarianceOfProduct(fix.T_reference_session, fix.covariance, T_session_base));
  return message;
}

}  // namespace

InitialPosePublisher::InitialPosePublisher(ros::NodeHandle node, const RobotPoseSource& robot, bool enabled)
    : robot_(robot), enabled_(enabled) {
  if (enabled_) {
    publisher_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>(ros_common::names::kInitialPose, 1);
  }
}

void InitialPosePublisher::set(const Fix& fix) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sent_ && !isElsewhere(fix)) {
    sent_ = fix;
    return;
  }
  pending_ = fix;
  sent_.reset();
}

void InitialPosePublisher::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  pending_.reset();
  sent_.reset();
}

void InitialPosePublisher::publishPending() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!enabled_ || !pending_ || publisher_.getNumSubscribers() <= kOwnSubscribers) {
    return;
  }
  const RobotPose robot = robot_.at(pending_->session_frame, pending_->stamp);
  if (!robot.T_session_base) {
    return;
  }
  const geometry_msgs::PoseWithCovarianceStamped message = messageOf(*pending_, *robot.T_session_base);
  ROS_INFO_STREAM("the robot's pose at " << pending_->stamp << " is sent on " << publisher_.getTopic());
  publisher_.publish(message);
  sent_ = std::exchange(pending_, std::nullopt);
}

bool InitialPosePublisher::isElsewhere(const Fix& fix) const {
  const RobotPose robot = robot_.atOrShortlyBefore(fix.session_frame, fix.stamp);
  const grid::Rigid2 T_session_base = robot.T_session_base.value_or(grid::Rigid2{});
  const grid::Rigid2 before = sent_->T_reference_session * T_session_base;
  const grid::Rigid2 now = fix.T_reference_session * T_session_base;
  return (now.translation() - before.translation()).norm() > kDistinctDistance ||
         std::abs(grid::normalizeAngle(now.yaw - before.yaw)) > kDistinctAngle;
}

}  // namespace map_matcher::ros_matching
