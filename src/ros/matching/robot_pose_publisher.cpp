#include "map_matcher/ros/matching/robot_pose_publisher.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/common/pose_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr std::uint32_t kQueue = 10;

}  // namespace

RobotPosePublisher::RobotPosePublisher(ros::NodeHandle node, RobotLocator& locator, double rate) : locator_(locator) {
  if (rate > 0.0) {
    publisher_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>(ros_common::names::kRobotPose, kQueue);
    timer_ = node.createTimer(ros::Duration(1.0 / rate), [this](const ros::TimerEvent&) { publish(); });
  }
}

void RobotPosePublisher::publish() {
  const std::optional<LocatedRobot> robot = locator_.locate(ros::Time::now());
  if (!robot || robot->stamp == last_) {
    return;
  }
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = robot->reference->frame;
  message.header.stamp = robot->stamp;
  message.pose = ros_common::toMessage(robot->pose.T_reference_base, robot->pose.covariance);
  publisher_.publish(message);
  last_ = robot->stamp;
}

}  // namespace map_matcher::ros_matching
