/// \file
/// Another reference map on request.
#pragma once

#if __has_include(<nav_msgs/LoadMap.h>)
#include <nav_msgs/LoadMap.h>
#endif
#include <nav_msgs/OccupancyGrid.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <functional>
#include <string>

namespace map_matcher::ros_matching {

/// Serves `change_map` as map_server does: the map of a YAML file becomes the reference map. On a thread of its own, so
/// that a large file keeps tf waiting for nothing. Where nav_msgs has no LoadMap, which came with its version 1.13.1,
/// there is no such service, and the log says so.
class ChangeMapService {
 public:
  /// Loads and uses the map of a YAML file, and returns it. Throws grid::MapFileError or ros_common::MessageError.
  using Load = std::function<nav_msgs::OccupancyGrid(const std::string& path)>;

  ChangeMapService(ros::NodeHandle node, Load load);
  ~ChangeMapService() { spinner_.stop(); }

  ChangeMapService(const ChangeMapService&) = delete;
  ChangeMapService& operator=(const ChangeMapService&) = delete;

 private:
#if __has_include(<nav_msgs/LoadMap.h>)
  void onChangeMap(const std::string& url, nav_msgs::LoadMap::Response& response) const;
#endif

  Load load_;
  ros::CallbackQueue queue_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace map_matcher::ros_matching
