#include "map_matcher/ros/matching/reference_source.hpp"

#include <ros/console.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>
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
  auto reference = std::make_shared<const ReferenceMap>(std::move(map), options, ros_common::frameOf(message.header));
  const grid::OccupancyGrid& grid = reference->map.grid();
  ROS_INFO_STREAM("reference map: " << grid.width() << " x " << grid.height() << " cells of " << grid.resolution()
                                    << " m, frame \"" << reference->frame << "\"");
  return reference;
}

/// The same of a map that was read from a file, which the error names.
ReferenceMapPtr referenceOfFile(const nav_msgs::OccupancyGrid& message, const std::string& path,
                                const search::SearchOptions& options) {
  try {
    return referenceOf(message, options);
  } catch (const ros_common::MessageError& error) {
    throw ros_common::MessageError("the reference map " + path + ": " + error.what());
  }
}

/// One map under two names would be two places that fit equally well, always.
void requireDistinct(const std::map<std::string, std::string>& files) {
  std::map<std::string, std::string> names;
  for (const auto& [name, path] : files) {
    std::error_code unreadable;  // of a file that does not exist, which whoever reads it tells
    const std::filesystem::path file = std::filesystem::weakly_canonical(path, unreadable);
    const auto [other, is_new] = names.emplace(file.string(), name);
    if (!is_new) {
      throw std::invalid_argument("~reference_maps has " + path + " twice, as " + other->second + " and as " + name +
                                  ", expected a file for each");
    }
  }
}

}  // namespace

ReferenceSource::ReferenceSource(ros::NodeHandle node, const search::SearchOptions& options, Listener listener)
    : options_(options),
      listener_(std::move(listener)),
      subscriber_(node.subscribe(ros_common::names::kReferenceMap, 1, &ReferenceSource::onMap, this)) {}

nav_msgs::OccupancyGrid ReferenceSource::load(const std::string& yaml_path, const std::string& frame) {
  nav_msgs::OccupancyGrid map = ros_common::toMessage(grid::loadMap(yaml_path), frame, ros::Time::now());
  listener_({referenceOfFile(map, yaml_path, options_)});
  return map;
}

void ReferenceSource::loadAll(const std::map<std::string, std::string>& files) {
  requireDistinct(files);
  ReferenceMapList references;
  for (const auto& [frame, path] : files) {
    references.push_back(
        referenceOfFile(ros_common::toMessage(grid::loadMap(path), frame, ros::Time::now()), path, options_));
  }
  listener_(references);
}

void ReferenceSource::take(const nav_msgs::OccupancyGrid& message) {
  try {
    listener_({referenceOf(message, options_)});
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

}  // namespace map_matcher::ros_matching
