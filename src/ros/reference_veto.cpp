#include "map_matcher/ros/reference_veto.hpp"

#include <ros/console.h>

#include <algorithm>
#include <iterator>

#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_poses.hpp"

namespace map_matcher {

ReferenceVeto::ReferenceVeto(ros::NodeHandle node, const tf2::BufferCore& tf, double distance)
    : tf_(tf), distance_(distance) {
  if (distance > 0.0) {
    subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
        "reference_map", 1, [this](const nav_msgs::OccupancyGridConstPtr& message) { onMap(*message); });
  }
}

void ReferenceVeto::onMap(const nav_msgs::OccupancyGrid& message) {
  try {
    reference_frame_ = frameOf(message.header);
    near_walls_.emplace(fromMessage(message), distance_);
  } catch (const MessageError& error) {
    ROS_WARN_STREAM("reference_map dropped: " << error.what());
  }
}

int ReferenceVeto::apply(DetectionSet& set) const {
  if (!near_walls_ || set.detections.empty()) {
    return 0;
  }
  // As in the fixed frame of the map, which does not move.
  const DetectionPose pose =
      DetectionPoses(tf_, reference_frame_).lookUp({set.frame, set.stamp}, {reference_frame_, set.stamp});
  if (!pose.T_scan_set) {
    return 0;  // not localized
  }
  const auto is_on_wall = [&](const Detection& detection) {
    return near_walls_->isNearWall((*pose.T_scan_set * detection.position).head<2>());
  };
  std::vector<Detection>& detections = set.detections;
  const auto end = std::remove_if(detections.begin(), detections.end(), is_on_wall);
  const auto num_removed = static_cast<int>(std::distance(end, detections.end()));
  detections.erase(end, detections.end());
  return num_removed;
}

}  // namespace map_matcher
