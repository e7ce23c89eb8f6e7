#include "map_matcher/ros/matching/overlay_publisher.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr double kTextShare = 0.035;     // of the reference map's width that a letter is high
constexpr double kLeastText = 0.3;       // [m]
constexpr std::size_t kOtherPlaces = 2;  // that are shown

std_msgs::ColorRGBA colour(float red, float green, float blue, float alpha = 1.0F) {
  std_msgs::ColorRGBA colour;
  colour.r = red;
  colour.g = green;
  colour.b = blue;
  colour.a = alpha;
  return colour;
}

visualization_msgs::Marker markerIn(const std::string& frame) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;  // stamp zero: at the newest transform
  marker.action = visualization_msgs::Marker::ADD;
  marker.frame_locked = true;
  marker.pose.orientation.w = 1.0;
  return marker;
}

/// A square for each cell; a marker without points, which rviz complains about, becomes one that deletes.
visualization_msgs::Marker marker(const std::vector<Eigen::Vector2d>& cells, const std::string& frame,
                                  double resolution, const std_msgs::ColorRGBA& colour) {
  visualization_msgs::Marker marker = markerIn(frame);
  marker.type = visualization_msgs::Marker::POINTS;
  if (cells.empty()) {
    marker.action = visualization_msgs::Marker::DELETE;
  }
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

std_msgs::ColorRGBA colourOf(std::uint8_t state) {
  switch (state) {
    case MapMatch::LOCALIZED:
      return colour(0.2F, 0.9F, 0.3F);
    case MapMatch::LOST:
      return colour(1.0F, 0.3F, 0.3F);
    default:
      return colour(1.0F, 0.8F, 0.1F);
  }
}

/// "localized, probability 0.987", or "searching: ambiguous". Never a probability of 1.
std::string textOf(const MapMatch& report) {
  if (report.status != MapMatch::MATCHED) {
    return report.state_text + ": " + report.status_text;
  }
  std::array<char, 16> probability{};
  std::snprintf(probability.data(), probability.size(), "%.3f", std::min(report.probability, 0.999));
  return report.state_text + ", probability " + probability.data();
}

/// The box around a grid, along the axes of its frame [m].
Eigen::AlignedBox2d boxAround(const grid::GridGeometry& geometry) {
  Eigen::AlignedBox2d box;
  for (const double x : {0.0, geometry.width * geometry.resolution}) {
    for (const double y : {0.0, geometry.height * geometry.resolution}) {
      box.extend(geometry.T_map_grid * Eigen::Vector2d(x, y));
    }
  }
  return box;
}

}  // namespace

OverlayPublisher::LatchedMarker::LatchedMarker(ros::NodeHandle& node, const std::string& topic)
    : publisher_(node.advertise<visualization_msgs::Marker>(topic, 1, true)), topic_(topic) {}

void OverlayPublisher::LatchedMarker::show(visualization_msgs::Marker marker) {
  frame_ = marker.header.frame_id;
  marker.ns = topic_;
  publisher_.publish(marker);
}

void OverlayPublisher::LatchedMarker::clear() {
  if (!frame_.empty()) {
    visualization_msgs::Marker nothing = markerIn(frame_);
    nothing.action = visualization_msgs::Marker::DELETE;
    show(std::move(nothing));
  }
}

OverlayPublisher::OverlayPublisher(ros::NodeHandle node)
    : matched_(node, ros_common::names::kMatchedCells),
      unmatched_(node, ros_common::names::kUnmatchedCells),
      other_places_(node, ros_common::names::kOtherPlaces),
      text_(node, ros_common::names::kMatchText) {}

void OverlayPublisher::publish(const search::MatchedCells& cells, const std::string& frame, double resolution) {
  matched_.show(marker(cells.matched, frame, resolution, colour(1.0F, 0.0F, 0.0F)));
  unmatched_.show(marker(cells.unmatched, frame, resolution, colour(0.1F, 0.4F, 1.0F)));
}

void OverlayPublisher::publishOtherPlaces(const search::MatchedCells& cells, const belief::Answer& answer,
                                          const std::string& frame, double resolution) {
  std::vector<Eigen::Vector2d> ghosts;
  for (std::size_t k = answer.matched() ? 1 : 0; k < std::min(answer.candidates.size(), kOtherPlaces); ++k) {
    const belief::Candidate& candidate = answer.candidates[k];
    if (candidate.map != answer.map) {
      continue;
    }
    for (const std::vector<Eigen::Vector2d>* part : {&cells.matched, &cells.unmatched}) {
      for (const Eigen::Vector2d& p_session : *part) {
        ghosts.push_back(candidate.place.T_reference_session * p_session);
      }
    }
  }
  other_places_.show(marker(ghosts, frame, resolution, colour(0.0F, 0.8F, 0.8F, 0.8F)));
}

void OverlayPublisher::write(const MapMatch& report, const ReferenceMap& reference) {
  const Eigen::AlignedBox2d box = boxAround(reference.map.grid().geometry());
  visualization_msgs::Marker marker = markerIn(reference.frame);
  marker.type = visualization_msgs::Marker::TEXT_VIEW_FACING;
  marker.scale.z = std::max(kLeastText, kTextShare * box.sizes().x());
  marker.pose.position.x = box.center().x();
  marker.pose.position.y = box.max().y() + marker.scale.z;
  marker.color = colourOf(report.state);
  marker.text = textOf(report);
  text_.show(std::move(marker));
}

void OverlayPublisher::clear() {
  for (LatchedMarker* shown : {&matched_, &unmatched_, &other_places_, &text_}) {
    shown->clear();
  }
}

}  // namespace map_matcher::ros_matching
