/// \file
/// The reference map for everybody, as map_server serves one.
#pragma once

#include <nav_msgs/GetMap.h>
#include <ros/node_handle.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/ros/matching/reference_map.hpp"

namespace map_matcher::ros_matching {

/// Publishes the reference map in use, latched, on the private topic `reference_map`, and if wanted on `map` and
/// `map_metadata`, and answers `static_map`, so that what is used here and what a planner drives on is one map. Of
/// several reference maps, that is the one which the robot was last found in. Thread-safe.
class MapServing {
 public:
  /// Serves it as map_server does only if `enabled`. Throws std::invalid_argument when maps are taken from a topic
  /// that this one is served on: `taken` are the names of these topics.
  MapServing(ros::NodeHandle node, ros::NodeHandle private_node, bool enabled, const std::vector<std::string>& taken);

  /// Serves this map from now on.
  void serve(const ReferenceMapPtr& reference);

 private:
  bool onGetMap(nav_msgs::GetMap::Response& response);

  const bool enabled_;
  std::mutex mutex_;  // guards both below
  ReferenceMapPtr reference_;
  std::optional<nav_msgs::OccupancyGrid> map_;
  ros::Publisher reference_publisher_;
  ros::Publisher map_publisher_;
  ros::Publisher metadata_publisher_;
  ros::ServiceServer static_map_;
};

}  // namespace map_matcher::ros_matching
