#include "map_matcher/ros/matching/initial_pose_source.hpp"

#include <ros/console.h>
#include <ros/this_node.h>

#include <sstream>
#include <utility>

#include "map_matcher/grid/pose_covariance.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/common/pose_messages.hpp"
#include "map_matcher/ros/common/stamps.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr const char* kPoseName = "the pose";

}  // namespace

std::string problemWithInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message,
                                   const ReferenceMapList& references) {
  const std::string frame = ros_common::frameName(message.header.frame_id);
  const auto reference = findFrame(references, frame);
  if (reference == references.end()) {
    return "it is in the frame \"" + frame + "\", expected that of " +
           (references.size() == 1 ? "the reference map, " : "a reference map, one of ") + frameTexts(references) +
           " (rviz: Fixed Frame)";
  }
  grid::Rigid2 pose;
  try {
    pose = ros_common::fromMessage(message.pose.pose, kPoseName);
  } catch (const ros_common::MessageError& error) {
    return error.what();
  }
  const grid::GridGeometry& geometry = (*reference)->map.grid().geometry();
  if (!geometry.contains(geometry.cellAt(pose.translation()))) {
    std::ostringstream text;
    text << "(" << pose.x << " m, " << pose.y << " m) lies outside the reference map of frame \"" << frame << "\"";
    return text.str();
  }
  return grid::problemWithCovariance(ros_common::planarCovariance(message.pose));
}

InitialPoseSource::InitialPoseSource(ros::NodeHandle node, const RobotPoseSource& robot, MapsLookup maps,
                                     Listener listener)
    : robot_(robot), maps_(std::move(maps)), listener_(std::move(listener)) {
  subscriber_ = node.subscribe<geometry_msgs::PoseWithCovarianceStamped, const PoseEvent&>(
      ros_common::names::kInitialPose, 1, [this](const PoseEvent& event) { onPose(event); });
}

void InitialPoseSource::onPose(const PoseEvent& event) {
  if (event.getPublisherName() == ros::this_node::getName()) {
    return;
  }
  const ros::Time now = ros::Time::now();
  pending_ = Pending{event.getConstMessage(), event.getPublisherName(), now};
  const std::string why = problem();
  if (!why.empty()) {
    ignore(why);
    return;
  }
  handOver(now);
}

void InitialPoseSource::handOver(const ros::Time& now) {
  if (!pending_) {
    return;
  }
  const std::string why = problem();  // the maps may have changed meanwhile
  if (!why.empty()) {
    ignore(why);
    return;
  }
  const geometry_msgs::PoseWithCovarianceStamped& message = *pending_->message;
  const MapsInUse maps = maps_();
  const std::string& session_frame = maps.session_frame;
  const ros::Time stamp = message.header.stamp.isZero() ? pending_->since : message.header.stamp;
  const bool is_late = ros_common::secondsBetween(pending_->since, now) > kPatience || now < pending_->since;
  const RobotPose robot = is_late ? robot_.atOrShortlyBefore(session_frame, stamp) : robot_.at(session_frame, stamp);
  if (robot.T_session_base) {
    const grid::Rigid2 pose = ros_common::fromMessage(message.pose.pose, kPoseName);
    ROS_INFO_STREAM("the initialpose of " << pending_->publisher << " is (" << pose.x << " m, " << pose.y << " m, "
                                          << pose.yaw << " rad): it is weighed against what the next map shows");
    const auto reference = findFrame(maps.references, ros_common::frameName(message.header.frame_id));
    const belief::Prior prior = belief::priorOfRobot(pose, ros_common::planarCovariance(message.pose),
                                                     *robot.T_session_base, ros_common::names::kInitialPose,
                                                     static_cast<std::size_t>(reference - maps.references.begin()));
    pending_.reset();
    listener_(prior);
  } else if (is_late) {
    ignore(robot.reason);
  }
}

/// Why the pose that waits cannot be used with the maps at hand; "" when it can.
std::string InitialPoseSource::problem() const {
  const MapsInUse maps = maps_();
  if (maps.references.empty()) {
    return "there is no reference map yet";
  }
  if (maps.session_frame.empty()) {
    return "there is no session map yet";
  }
  return problemWithInitialPose(*pending_->message, maps.references);
}

void InitialPoseSource::ignore(const std::string& why) {
  ROS_WARN_STREAM("the initialpose of " << pending_->publisher << " is ignored: " << why);
  pending_.reset();
}

}  // namespace map_matcher::ros_matching
