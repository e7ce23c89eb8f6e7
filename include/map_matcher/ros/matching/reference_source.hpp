/// \file
/// Where the reference maps come from.
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "map_matcher/ros/matching/reference_map.hpp"

namespace map_matcher::ros_matching {

/// Takes reference maps from files, the topic `reference_map` and callers, and refuses those that cannot be used.
/// Thread-safe.
class ReferenceSource {
 public:
  /// Told of the reference maps that replace those before them.
  using Listener = std::function<void(const ReferenceMapList&)>;

  /// `options` are those of the searches in the maps. A map needs a cell of options.occupied_threshold.
  ReferenceSource(ros::NodeHandle node, const search::SearchOptions& options, Listener listener);

  /// Takes the map of a map_server YAML file, as one of `frame`, in place of all others, and returns it. Throws
  /// MapFileError or MessageError.
  nav_msgs::OccupancyGrid load(const std::string& yaml_path, const std::string& frame);

  /// Takes the maps of several such files; their names are their frames. Throws as load() does, and
  /// std::invalid_argument for two names of one file.
  void loadAll(const std::map<std::string, std::string>& files);

  /// Takes the map of a message in place of all others. Throws MessageError when it cannot be used; then the old one
  /// stays.
  void take(const nav_msgs::OccupancyGrid& message);

  /// Maps on the topic or from callers that could not be used so far.
  std::uint32_t dropped() const { return dropped_; }

  /// Full name of the topic that reference maps are taken from.
  std::string topic() const { return subscriber_.getTopic(); }

 private:
  void onMap(const nav_msgs::OccupancyGridConstPtr& message);

  const search::SearchOptions options_;
  Listener listener_;
  std::atomic<std::uint32_t> dropped_{0};
  ros::Subscriber subscriber_;
};

}  // namespace map_matcher::ros_matching
