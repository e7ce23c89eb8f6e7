#include "map_matcher/ros/evaluation/overlay_recorder.hpp"

#include <ros/console.h>

#include <filesystem>
#include <stdexcept>

#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_evaluation {

parameters::ParameterList parametersOf(OverlayRecorderOptions& options) {
  return {{"directory", "", "Existing directory that the files are written into.", &options.directory}};
}

OverlayRecorder::OverlayRecorder(ros::NodeHandle node, const ros::NodeHandle& /*private_node*/,
                                 const OverlayRecorderOptions& options)
    : options_(options) {
  std::error_code unreadable;
  if (!std::filesystem::is_directory(options_.directory, unreadable)) {
    throw std::invalid_argument("~directory is \"" + options_.directory + "\", expected an existing directory");
  }
  match_subscriber_ = node.subscribe(ros_common::names::kMapMatch, 1, &OverlayRecorder::onMatch, this);
  session_subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
      ros_common::names::kSessionMap, 1, [this](const nav_msgs::OccupancyGridConstPtr& map) { session_map_ = map; });
  reference_subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
      ros_common::names::kReferenceMap, 1,
      [this](const nav_msgs::OccupancyGridConstPtr& map) { reference_map_ = map; });
}

OverlayRecorder::~OverlayRecorder() {
  try {
    write();
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("the last match is not recorded: " << error.what());
  }
}

void OverlayRecorder::onMatch(const MapMatchConstPtr& message) {
  if (message->status == MapMatch::MATCHED) {
    T_reference_session_ = grid::Rigid2{message->x, message->y, message->yaw};
  }
}

void OverlayRecorder::write() const {
  if (!session_map_) {
    ROS_WARN_STREAM("no session map came: nothing is recorded");
    return;
  }
  const grid::OccupancyGrid session = ros_common::fromMessage(*session_map_);
  grid::saveMap(session, options_.directory + "/session_map.yaml");
  if (T_reference_session_ && reference_map_) {
    evaluation::writeOverlayImage(options_.directory + "/overlay.png", ros_common::fromMessage(*reference_map_),
                                  session, T_reference_session_);
  }
  ROS_INFO_STREAM("the last session map and its overlay are in " << options_.directory);
}

}  // namespace map_matcher::ros_evaluation
