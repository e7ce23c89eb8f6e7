/// \file
/// Another reference map on request.
#pragma once

#include <nav_msgs/LoadMap.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <functional>
#include <string>

namespace map_matcher::ros_matching {

/// The path that a map's URL names: a path as it is, or that of file:///path. Throws std::invalid_argument for any
/// other URL.
std::string pathOfMapUrl(const std::string& url);

/// Serves `change_map` as map_server does: the map of a YAML file becomes the reference map. On a thread of its own, so
/// that a large file keeps tf waiting for nothing.
class ChangeMapService {
 public:
  /// Loads and uses the map of a YAML file, and returns it. Throws grid::MapFileError or ros_common::MessageError.
  using Load = std::function<nav_msgs::OccupancyGrid(const std::string& path)>;

  ChangeMapService(ros::NodeHandle node, Load load);
  ~ChangeMapService() { spinner_.stop(); }

  ChangeMapService(const ChangeMapService&) = delete;
  ChangeMapService& operator=(const ChangeMapService&) = delete;

 private:
  void onChangeMap(const std::string& url, nav_msgs::LoadMap::Response& response) const;

  Load load_;
  ros::CallbackQueue queue_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace map_matcher::ros_matching
