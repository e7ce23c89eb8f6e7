/// \file
/// Where the reference map comes from.
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include "map_matcher/ros/matching/reference_map.hpp"

namespace map_matcher::ros_matching {

/// Takes reference maps from a file, the topic `reference_map` and callers, refuses those that cannot be used, and
/// publishes the one in use, latched, on the private topic `reference_map`. Thread-safe.
class ReferenceSource {
 public:
  /// Told of every reference map that replaces the one before it.
  using Listener = std::function<void(const ReferenceMapPtr&)>;

  /// `options` are those of the searches in the maps. A map needs a cell of options.occupied_threshold.
  ReferenceSource(ros::NodeHandle node, ros::NodeHandle private_node, const search::SearchOptions& options,
                  Listener listener);

  /// Takes the map of a map_server YAML file, as one of `frame`, and returns it. Throws MapFileError or MessageError.
  nav_msgs::OccupancyGrid load(const std::string& yaml_path, const std::string& frame);

  /// Takes the map of a message. Throws MessageError when it cannot be used; then the old one stays.
  void take(const nav_msgs::OccupancyGrid& message);

  /// Maps on the topic or from callers that could not be used so far.
  std::uint32_t dropped() const { return dropped_; }

  /// Full name of the topic that reference maps are taken from.
  std::string topic() const { return subscriber_.getTopic(); }

 private:
  void onMap(const nav_msgs::OccupancyGridConstPtr& message);
  void use(const nav_msgs::OccupancyGrid& message);

  const search::SearchOptions options_;
  Listener listener_;
  std::atomic<std::uint32_t> dropped_{0};
  std::mutex use_mutex_;  // the map published last is the one that the listener heard of last
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace map_matcher::ros_matching
