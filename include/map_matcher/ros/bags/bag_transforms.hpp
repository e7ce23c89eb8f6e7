/// \file
/// The transforms of a bag.
#pragma once

#include <ros/duration.h>
#include <ros/time.h>
#include <rosbag/bag.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <string>

namespace map_matcher::ros_bags {

/// Takes what a bag holds of tf, message by message, into a buffer.
class BagTransforms {
 public:
  /// `history`: how long transforms are kept.
  explicit BagTransforms(const ros::Duration& history = ros::Duration(30.0)) : buffer_(history) {}

  /// All of /tf_static.
  void takeStatic(const rosbag::Bag& bag);

  /// A message of /tf. A transform with the stamp of the one before says nothing new: slam_gmapping repeats its last
  /// one while the clock of a replay stands still.
  void take(const tf2_msgs::TFMessage& message);

  const tf2::BufferCore& buffer() const { return buffer_; }

 private:
  tf2::BufferCore buffer_;
  std::map<std::string, ros::Time> last_stamps_;  // by the child frame
};

}  // namespace map_matcher::ros_bags
