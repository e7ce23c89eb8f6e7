#include "map_matcher/ros/scrubbing/reference_veto.hpp"

#include <ros/console.h>

#include <exception>

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_scrubbing {

ReferenceVeto::ReferenceVeto(ros::NodeHandle node, const scrubbing::FrameTransforms& transforms, double distance)
    : transforms_(transforms), distance_(distance) {
  if (isAskedFor()) {
    subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
        "reference_map", 1, [this](const nav_msgs::OccupancyGridConstPtr& message) { onMap(*message); });
  }
}

void ReferenceVeto::onMap(const nav_msgs::OccupancyGrid& message) {
  try {
    reference_ =
        Reference{ros_common::frameOf(message.header), grid::NearWalls(ros_common::fromMessage(message), distance_)};
  } catch (const std::exception& error) {  // also one for which there is no memory
    ++dropped_maps_;
    ROS_WARN_STREAM("reference_map dropped: " << error.what());
  }
}

scrubbing::Veto ReferenceVeto::at(const scrubbing::FrameAt& detector) const {
  if (!reference_) {
    return nullptr;
  }
  const auto T_map_detector = scrubbing::poseAt(transforms_, reference_->frame, detector, scrubbing::kMaxTransformAge);
  if (!T_map_detector) {
    return nullptr;  // not localized
  }
  return [this, T = *T_map_detector](const scrubbing::Detection& detection) {
    return reference_->near_walls.isNearWall((T * detection.position).head<2>());
  };
}

}  // namespace map_matcher::ros_scrubbing
