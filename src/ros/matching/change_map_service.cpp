#include "map_matcher/ros/matching/change_map_service.hpp"

#include <ros/console.h>

#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/matching/map_url.hpp"

namespace map_matcher::ros_matching {

#if __has_include(<nav_msgs/LoadMap.h>)

namespace {

using Response = nav_msgs::LoadMap::Response;

/// The result code for a map that cannot be used.
std::uint8_t codeOf(const std::string& path) {
  if (path.empty()) {  // of a URL that names none
    return Response::RESULT_UNDEFINED_FAILURE;
  }
  std::error_code unreadable;
  if (!std::filesystem::exists(path, unreadable)) {
    return Response::RESULT_MAP_DOES_NOT_EXIST;
  }
  try {
    grid::imageNamedBy(path);
  } catch (const grid::MapFileError&) {
    return Response::RESULT_INVALID_MAP_METADATA;
  }
  return Response::RESULT_INVALID_MAP_DATA;
}

}  // namespace

ChangeMapService::ChangeMapService(ros::NodeHandle node, Load load) : load_(std::move(load)) {
  node.setCallbackQueue(&queue_);
  service_ = node.advertiseService<nav_msgs::LoadMap::Request, Response>(
      ros_common::names::kChangeMap, [this](nav_msgs::LoadMap::Request& request, Response& response) {
        onChangeMap(request.map_url, response);
        return true;
      });
  spinner_.start();
}

void ChangeMapService::onChangeMap(const std::string& url, Response& response) const {
  std::string path;
  try {
    path = pathOfMapUrl(url);
    response.map = load_(path);
    response.result = Response::RESULT_SUCCESS;
    return;
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("change_map: the reference map stays as it is: " << error.what());
  }
  response.result = codeOf(path);
}

#else

ChangeMapService::ChangeMapService(ros::NodeHandle /*node*/, Load load) : load_(std::move(load)) {
  ROS_INFO_STREAM("there is no service change_map: this nav_msgs has no LoadMap, which came with its version 1.13.1");
}

#endif

}  // namespace map_matcher::ros_matching
