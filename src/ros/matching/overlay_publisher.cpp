#include "map_matcher/ros/matching/overlay_publisher.hpp"

#include <visualization_msgs/Marker.h>

#include <string>
#include <vector>

#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_matching {
namespace {

std_msgs::ColorRGBA colour(float red, float green, float blue) {
  std_msgs::ColorRGBA colour;
  colour.r = red;
  colour.g = green;
  colour.b = blue;
  colour.a = 1.0F;
  return colour;
}

/// A square for each cell; a marker without points, which rviz complains about, becomes one that deletes.
visualization_msgs::Marker marker(const std::string& name, const std::vector<Eigen::Vector2d>& cells,
                                  const std::string& frame, double resolution, const std_msgs::ColorRGBA& colour) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;  // stamp zero: at the newest transform
  marker.ns = name;
  marker.type = visualization_msgs::Marker::POINTS;
  marker.action = cells.empty() ? visualization_msgs::Marker::DELETE : visualization_msgs::Marker::ADD;
  marker.frame_locked = true;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = resolution;
  marker.scale.y = resolution;
  marker.color = colour;
  marker.points.reserve(cells.size());
  for (const Eigen::Vector2d& p : cells) {
    geometry_msgs::Point point;
    point.x = p.x();
    point.y = p.y();
    marker.points.push_back(point);
  }
  return marker;
}

}  // namespace

OverlayPublisher::OverlayPublisher(ros::NodeHandle node)
    : matched_(node.advertise<visualization_msgs::Marker>(ros_common::names::kMatchedCells, 1, true)),
      unmatched_(node.advertise<visualization_msgs::Marker>(ros_common::names::kUnmatchedCells, 1, true)) {}

void OverlayPublisher::publish(const search::MatchedCells& cells, const std::string& frame, double resolution) {
  frame_ = frame;
  matched_.publish(
      marker(ros_common::names::kMatchedCells, cells.matched, frame, resolution, colour(1.0F, 0.0F, 0.0F)));
  unmatched_.publish(
      marker(ros_common::names::kUnmatchedCells, cells.unmatched, frame, resolution, colour(0.1F, 0.4F, 1.0F)));
}

void OverlayPublisher::clear() {
  if (!frame_.empty()) {
    publish({}, frame_, 0.0);
  }
}

}  // namespace map_matcher::ros_matching
