#include "map_matcher/ros/matching/map_serving.hpp"

#include <ros/console.h>

#include <algorithm>
#include <stdexcept>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_matching {
namespace {

/// Otherwise the node would take its own map for a new one, again and again.
void requireNotTaken(const std::string& topic, const std::vector<std::string>& taken, const std::string& what) {
  if (std::find(taken.begin(), taken.end(), topic) != taken.end()) {
    throw std::invalid_argument(what + ", but maps are taken from " + topic +
                                ", on which the reference map would be served: let the mapper publish elsewhere "
                                "(_map:=session_map), and remap session_map and reference_map accordingly");
  }
}

}  // namespace

MapServing::MapServing(ros::NodeHandle node, ros::NodeHandle private_node, bool enabled,
                       const std::vector<std::string>& taken)
    : enabled_(enabled) {
  const std::string reference_topic = private_node.resolveName(ros_common::names::kReferenceMap);
  requireNotTaken(reference_topic, taken, "~reference_map is remapped to " + reference_topic);
  reference_publisher_ = private_node.advertise<nav_msgs::OccupancyGrid>(ros_common::names::kReferenceMap, 1, true);
  if (!enabled_) {
    return;
  }
  requireNotTaken(node.resolveName(ros_common::names::kMap), taken, "~serve_map is true");
  map_publisher_ = node.advertise<nav_msgs::OccupancyGrid>(ros_common::names::kMap, 1, true);
  metadata_publisher_ = node.advertise<nav_msgs::MapMetaData>(ros_common::names::kMapMetadata, 1, true);
  static_map_ = node.advertiseService<nav_msgs::GetMap::Request, nav_msgs::GetMap::Response>(
      ros_common::names::kStaticMap, [this](nav_msgs::GetMap::Request& /*request*/,
                                            nav_msgs::GetMap::Response& response) { return onGetMap(response); });
}

void MapServing::serve(const ReferenceMapPtr& reference) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (reference == reference_) {
    return;
  }
  reference_ = reference;
  const nav_msgs::OccupancyGrid map = ros_common::toMessage(reference->map.grid(), reference->frame, ros::Time::now());
  reference_publisher_.publish(map);
  if (!enabled_) {
    return;
  }
  map_ = map;
  map_publisher_.publish(map);
  metadata_publisher_.publish(map.info);
}

bool MapServing::onGetMap(nav_msgs::GetMap::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!map_) {
    ROS_WARN_STREAM("static_map was asked for, but it is not known yet which reference map the robot is in");
    return false;
  }
  response.map = *map_;
  return true;
}

}  // namespace map_matcher::ros_matching
