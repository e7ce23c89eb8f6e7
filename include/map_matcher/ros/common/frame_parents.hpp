/// \file
/// Who else says where a tf frame lies.
#pragma once

#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace map_matcher::ros_common {

/// A transform to a frame, as another node broadcasts it.
struct FrameParent {
  std::string parent;     ///< Frame above it.
  std::string publisher;  ///< Name of the node that says so.
};

/// A frame that several nodes give different parents to.
struct ContestedFrame {
  std::string frame;
  std::vector<FrameParent> parents;  ///< What each of those nodes says, by their names' order.
};

/// Remembers the parents that other nodes give to frames. A frame has one parent (REP 105): a node that is about to
/// broadcast asks here first. The tf buffer cannot tell, as it does not know who said what. Not thread-safe.
class FrameParents {
 public:
  /// A parent on /tf is no longer there when it was not heard of for three times the longest time that lay between two
  /// of its transforms, but for no less than kLeastMemory and no more than kMostMemory [s].
  static constexpr double kLeastMemory = 10.0;
  static constexpr double kMostMemory = 60.0;

  /// Notes what `publisher`, another node than this one, sent on /tf, or on /tf_static, where it holds for good.
  void add(const tf2_msgs::TFMessage& message, const std::string& publisher, bool is_static, const ros::Time& now);

  /// The parent that another node gives to `child` at present: a static one before others, the newest before older.
  std::optional<FrameParent> parentOf(const std::string& child, const ros::Time& now) const;

  /// Those of `frames` that different nodes give different parents to at present, in the order of `frames`. What this
  /// node sends does not count.
  std::vector<ContestedFrame> contestedAmong(const std::vector<std::string>& frames, const ros::Time& now) const;

 private:
  /// What one publisher says of one frame.
  struct Entry {
    std::string parent;
    bool is_static = false;
    ros::Time heard;
    double longest_interval = 0.0;  // between two transforms [s]
  };
  using ByPublisher = std::map<std::string, Entry>;

  static bool isPresent(const Entry& entry, const ros::Time& now);

  std::map<std::string, ByPublisher> by_child_;
};

}  // namespace map_matcher::ros_common
