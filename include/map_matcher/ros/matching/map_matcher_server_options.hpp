/// \file
/// What can be chosen about the map_matcher node.
#pragma once

#include <map>
#include <string>

#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/ros/matching/robot_announcer_options.hpp"

namespace map_matcher::ros_matching {

/// Options of the map_matcher node. Their ranges stand in parametersOf().
struct MapMatcherServerOptions {
  std::string reference_map_file;       ///< YAML file of the reference map; empty: it comes by topic or service.
  std::string reference_frame = "map";  ///< Frame of the map read from reference_map_file.
  std::map<std::string, std::string> reference_maps;  ///< YAML files of several reference maps, by their frames.
  std::string map_root;                               ///< Folder that change_map may load maps from; empty: any.
  std::string base_frame = "base_link";               ///< Frame of the robot whose pose is sent as match_pose.
  std::string tf_mode = "reference_to_session";       ///< Which frame is the parent: see tfModeOf().
  double tf_rate = 20.0;                              ///< [Hz] Broadcasts a second.
  double transform_tolerance = 0.1;                   ///< [s] How far into the future the transform is stamped.
  bool serve_map = false;                             ///< Whether the reference map is served as map_server serves one.
  bool publish_speech = false;                        ///< Whether the robot says that it was found or lost.
  RobotAnnouncerOptions robot;
  belief::MatchOptions match;
};

/// The parameters that fill `options`, by the names they have in config/map_matcher.yaml.
parameters::ParameterList parametersOf(MapMatcherServerOptions& options);

}  // namespace map_matcher::ros_matching
