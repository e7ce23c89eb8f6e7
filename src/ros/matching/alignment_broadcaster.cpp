#include "map_matcher/ros/matching/alignment_broadcaster.hpp"

#include <ros/console.h>
#include <ros/this_node.h>

#include <stdexcept>

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr std::uint32_t kTfQueue = 100;

geometry_msgs::TransformStamped transformOf(const Alignment& alignment, TfMode mode) {
  const bool session_is_parent = mode == TfMode::kSessionToReference;
  const grid::Rigid2& T = alignment.T_reference_session;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = session_is_parent ? alignment.session_frame : alignment.reference_frame;
  transform.child_frame_id = session_is_parent ? alignment.reference_frame : alignment.session_frame;
  transform.transform = ros_common::toTransformMessage(session_is_parent ? T.inverse() : T);
  return transform;
}

}  // namespace

TfMode tfModeOf(const std::string& text) {
  if (text == "reference_to_session") {
    return TfMode::kReferenceToSession;
  }
  if (text == "session_to_reference") {
    return TfMode::kSessionToReference;
  }
  if (text == "none") {
    return TfMode::kNone;
  }
  throw std::invalid_argument("tf_mode is \"" + text +
                              "\", expected reference_to_session | session_to_reference | none");
}

AlignmentBroadcaster::AlignmentBroadcaster(ros::NodeHandle node, TfMode mode, double transform_tolerance)
    : mode_(mode), transform_tolerance_(transform_tolerance) {
  tf_subscriber_ = node.subscribe<tf2_msgs::TFMessage, const TfEvent&>(
      "/tf", kTfQueue, [this](const TfEvent& event) { onTf(event, false); });
  tf_static_subscriber_ = node.subscribe<tf2_msgs::TFMessage, const TfEvent&>(
      "/tf_static", kTfQueue, [this](const TfEvent& event) { onTf(event, true); });
}

void AlignmentBroadcaster::set(const Alignment& alignment) {
  const std::lock_guard<std::mutex> lock(mutex_);
  alignment_ = alignment;
}

void AlignmentBroadcaster::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  alignment_.reset();
  contest_.reset();
}

bool AlignmentBroadcaster::isContested() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return contest_.has_value();
}

std::optional<ros_common::ContestedFrame> AlignmentBroadcaster::contest() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return contest_;
}

std::vector<ros_common::ContestedFrame> AlignmentBroadcaster::contestedAmong(const std::vector<std::string>& frames,
                                                                             const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return others_.contestedAmong(frames, now);
}

void AlignmentBroadcaster::broadcast(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (mode_ == TfMode::kNone || !alignment_) {
    return;
  }
  geometry_msgs::TransformStamped transform = transformOf(*alignment_, mode_);
  lookForOthers(transform, now);
  if (contest_) {
    return;
  }
  transform.header.stamp = now + transform_tolerance_;
  broadcaster_.sendTransform(transform);
}

void AlignmentBroadcaster::onTf(const TfEvent& event, bool is_static) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (event.getPublisherName() != ros::this_node::getName()) {
    others_.add(*event.getConstMessage(), event.getPublisherName(), is_static, ros::Time::now());
  }
}

void AlignmentBroadcaster::lookForOthers(const geometry_msgs::TransformStamped& transform, const ros::Time& now) {
  const std::optional<ros_common::FrameParent> other = others_.parentOf(transform.child_frame_id, now);
  if (other && !contest_) {
    ROS_ERROR_STREAM(
        "the frame \"" << transform.child_frame_id << "\" already has the parent \"" << other->parent
                       << "\", broadcast by " << other->publisher << ": " << transform.header.frame_id << " -> "
                       << transform.child_frame_id << " is not broadcast. Stop that node, or set ~tf_mode to "
                       << (mode_ == TfMode::kReferenceToSession ? "session_to_reference" : "reference_to_session")
                       << " or none");
  } else if (!other && contest_) {
    ROS_INFO_STREAM("the frame \"" << transform.child_frame_id
                                   << "\" has no other parent any more: " << transform.header.frame_id << " -> "
                                   << transform.child_frame_id << " is broadcast again");
  }
  contest_.reset();
  if (other) {
    contest_ = {transform.child_frame_id, {{transform.header.frame_id, ros::this_node::getName()}, *other}};
  }
}

}  // namespace map_matcher::ros_matching
