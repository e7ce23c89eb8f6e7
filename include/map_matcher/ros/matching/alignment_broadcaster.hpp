/// \file
/// The accepted alignment on tf.
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_broadcaster.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/ros/common/frame_parents.hpp"

namespace map_matcher::ros_matching {

/// Which of the two map frames is the parent on tf.
enum class TfMode {
  kReferenceToSession,  ///< Parent: reference frame, child: session frame. For `map -> session_map -> odom`.
  kSessionToReference,  ///< Parent: session frame, child: reference frame. For a session frame that has a parent.
  kNone,                ///< Nothing is broadcast.
};

/// The mode of the parameter `tf_mode`: "reference_to_session", "session_to_reference" or "none".
/// Throws std::invalid_argument for any other text.
TfMode tfModeOf(const std::string& text);

/// Where the session map lies in the reference map.
struct Alignment {
  std::string reference_frame;
  std::string session_frame;
  grid::Rigid2 T_reference_session;
};

/// Sends the alignment on tf as long as no other node gives the child frame a parent. Thread-safe.
class AlignmentBroadcaster {
 public:
  /// Transforms are stamped `transform_tolerance` [s] ahead.
  AlignmentBroadcaster(ros::NodeHandle node, TfMode mode, double transform_tolerance);

  /// Broadcasts this alignment from now on.
  void set(const Alignment& alignment);

  /// Broadcasts nothing from now on.
  void clear();

  /// Sends the alignment once, if there is one; `now` rises strictly from call to call, except after clear().
  void broadcast(const ros::Time& now);

  /// Whether there was nothing sent at the last broadcast(), since another node gives the child frame a parent.
  bool isContested();

  /// The child frame with this node's parent and that of the other node, while there is one.
  std::optional<ros_common::ContestedFrame> contest();

  /// Those of `frames` that different nodes give different parents to at present. What this node sends does not count.
  std::vector<ros_common::ContestedFrame> contestedAmong(const std::vector<std::string>& frames, const ros::Time& now);

 private:
  using TfEvent = ros::MessageEvent<const tf2_msgs::TFMessage>;

  void onTf(const TfEvent& event, bool is_static);
  void lookForOthers(const geometry_msgs::TransformStamped& transform, const ros::Time& now);

  const TfMode mode_;
  const ros::Duration transform_tolerance_;
  std::mutex mutex_;  // guards all below
  std::optional<Alignment> alignment_;
  ros_common::FrameParents others_;
  std::optional<ros_common::ContestedFrame> contest_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Subscriber tf_subscriber_;
  ros::Subscriber tf_static_subscriber_;
};

}  // namespace map_matcher::ros_matching
