#include "map_matcher/ros/matching/reference_source.hpp"

#include <ros/console.h>

#include <utility>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_matching {
namespace {

/// The map of a message. Throws MessageError when it cannot serve as a reference.
ReferenceMapPtr referenceOf(const nav_msgs::OccupancyGrid& message, const search::SearchOptions& options) {
  grid::OccupancyGrid map = ros_common::fromMessage(message);
  if (grid::occupiedCells(map, static_cast<std::int8_t>(options.occupied_threshold)).empty()) {
    throw ros_common::MessageError("the map has no occupied cell among its " + std::to_string(map.values().size()) +
                                   ", expected at least one of " + std::to_string(options.occupied_threshold) +
                                   " percent or more");
  }
  return std::make_shared<const ReferenceMap>(std::move(map), options, ros_common::frameOf(message.header));
}

}  // namespace

ReferenceSource::ReferenceSource(ros::NodeHandle node, ros::NodeHandle private_node,
                                 const search::SearchOptions& options, Listener listener)
    : options_(options),
      listener_(std::move(listener)),
      publisher_(private_node.advertise<nav_msgs::OccupancyGrid>(ros_common::names::kReferenceMap, 1, true)),
      subscriber_(node.subscribe(ros_common::names::kReferenceMap, 1, &ReferenceSource::onMap, this)) {}

nav_msgs::OccupancyGrid ReferenceSource::load(const std::string& yaml_path, const std::string& frame) {
  nav_msgs::OccupancyGrid map = ros_common::toMessage(grid::loadMap(yaml_path), frame, ros::Time::now());
  try {
    use(map);
    return map;
  } catch (const ros_common::MessageError& error) {
    throw ros_common::MessageError("the reference map " + yaml_path + ": " + error.what());
  }
}

void ReferenceSource::take(const nav_msgs::OccupancyGrid& message) {
  try {
    use(message);
  } catch (const ros_common::MessageError&) {
    ++dropped_;
    throw;
  }
}

void ReferenceSource::onMap(const nav_msgs::OccupancyGridConstPtr& message) {
  try {
    take(*message);
  } catch (const ros_common::MessageError& error) {
    ROS_WARN_STREAM("reference map on " << topic() << " dropped (" << dropped_ << " so far): " << error.what());
  }
}

void ReferenceSource::use(const nav_msgs::OccupancyGrid& message) {
  const ReferenceMapPtr map = referenceOf(message, options_);
  ROS_INFO_STREAM("reference map: " << map->map.grid().width() << " x " << map->map.grid().height() << " cells of "
                                    << map->map.grid().resolution() << " m, frame \"" << map->frame << "\"");
  const std::lock_guard<std::mutex> lock(use_mutex_);
  publisher_.publish(message);
  listener_(map);
}

}  // namespace map_matcher::ros_matching
