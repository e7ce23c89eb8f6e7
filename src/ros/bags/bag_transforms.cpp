#include "map_matcher/ros/bags/bag_transforms.hpp"

#include <rosbag/view.h>

#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_bags {
namespace {

/// With the names of frames that tf2 takes.
geometry_msgs::TransformStamped renamed(geometry_msgs::TransformStamped transform) {
  transform.header.frame_id = ros_common::frameName(transform.header.frame_id);
  transform.child_frame_id = ros_common::frameName(transform.child_frame_id);
  return transform;
}

}  // namespace

void BagTransforms::takeStatic(const rosbag::Bag& bag) {
  rosbag::View view(bag, rosbag::TopicQuery(std::string("/tf_static")));
  forEachMessage(bag, view, [this](const rosbag::MessageInstance& message) {
    if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
      for (const geometry_msgs::TransformStamped& transform : transforms->transforms) {
        buffer_.setTransform(renamed(transform), "bag", true);
      }
    }
  });
}

void BagTransforms::take(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const auto [last, is_new] = last_stamps_.try_emplace(transform.child_frame_id, transform.header.stamp);
    if (is_new || last->second != transform.header.stamp) {
      last->second = transform.header.stamp;
      buffer_.setTransform(renamed(transform), "bag", false);
    }
  }
}

}  // namespace map_matcher::ros_bags
