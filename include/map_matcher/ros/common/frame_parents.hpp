/// \file
/// Who else says where a tf frame lies.
#pragma once

#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <optional>
#include <string>

namespace map_matcher::ros_common {

/// A transform to a frame, as another node broadcasts it.
struct FrameParent {
  std::string parent;     ///< Frame above it.
  std::string publisher;  ///< Name of the node that says so.
};

/// Remembers the parents that other nodes give to frames. A frame has one parent (REP 105): a node that is about to
/// broadcast asks here first. The tf buffer cannot tell, as it does not know who said what. Not thread-safe.
class FrameParents {
 public:
  /// A parent on /tf that was not heard of for so long is no longer there [s].
  static constexpr double kTimeout = 2.0;

  /// Notes what `publisher`, another node than this one, sent on /tf, or on /tf_static, where it holds for good.
  void add(const tf2_msgs::TFMessage& message, const std::string& publisher, bool is_static, const ros::Time& now);

  /// The parent that another node gives to `child` at present.
  std::optional<FrameParent> parentOf(const std::string& child, const ros::Time& now) const;

 private:
  struct Entry {
    FrameParent parent;
    bool is_static = false;
    ros::Time heard;
  };
  std::map<std::string, Entry> by_child_;
};

}  // namespace map_matcher::ros_common
