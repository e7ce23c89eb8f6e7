#include "map_matcher/ros/matching/map_matcher_server_options.hpp"

namespace map_matcher::ros_matching {

parameters::ParameterList parametersOf(MapMatcherServerOptions& options) {
  parameters::ParameterList parameters{
      {"reference_map_file", "",
       "YAML file of the reference map as map_server reads it; empty when the map comes by topic or service.",
       &options.reference_map_file},
      {"reference_maps", "",
       "YAML files of several reference maps, floors or buildings, by their frames; all of them are searched.",
       &options.reference_maps},
      {"reference_frame", "", "Frame of the map read from reference_map_file.", &options.reference_frame},
      {"map_root", "", "Folder that change_map may load maps from; empty is any.", &options.map_root},
      {"serve_map", "",
       "Whether the reference map is served as map_server serves one: on map and map_metadata, and by static_map.",
       &options.serve_map},
      {"base_frame", "", "Frame of the robot whose pose is sent as match_pose.", &options.base_frame},
      {"tf_mode",
       "",
       "Which map frame is broadcast as the parent of the other; none broadcasts nothing.",
       &options.tf_mode,
       {},
       {},
       {"reference_to_session", "session_to_reference", "none"}},
      {"tf_rate", "Hz", "Broadcasts of the transform in a second.", &options.tf_rate, 0.1, 1000.0},
      {"transform_tolerance", "s",
       "How far into the future the transform is stamped, so that it is there when the newest scan needs it.",
       &options.transform_tolerance, 0.0, 10.0},
      {"publish_speech", "",
       "Whether speech, for a robot that talks, is sent when the robot is found or lost: one sentence, once.",
       &options.publish_speech},
  };
  const parameters::ParameterList robot = parametersOf(options.robot);
  parameters.insert(parameters.end(), robot.begin(), robot.end());
  const parameters::ParameterList match = parametersOf(options.match);
  parameters.insert(parameters.end(), match.begin(), match.end());
  return parameters;
}

}  // namespace map_matcher::ros_matching
