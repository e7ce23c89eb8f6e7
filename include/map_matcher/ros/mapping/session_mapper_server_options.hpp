/// \file
/// What can be chosen about the session_mapper node.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/ros/mapping/session_mapping.hpp"

namespace map_matcher::ros_mapping {

/// Options of the session_mapper node, with slam_gmapping's names as parameters.
struct SessionMapperServerOptions {
  SessionMappingOptions mapping;
  std::vector<std::string> scan_topics{"scan"};  ///< Of the scans, one for each laser, at its mount in tf.
  std::string map_frame = "session_map";         ///< Frame of the map, the parent of odom_frame in tf.
  double transform_publish_period = 0.05;        ///< [s] Between two broadcasts of map_frame -> odom_frame; 0: none.
  double tf_delay = 0.05;                        ///< [s] How far into the future the broadcasts are stamped.
};

/// The parameters of config/session_mapper.yaml.
parameters::ParameterList parametersOf(SessionMapperServerOptions& options);

}  // namespace map_matcher::ros_mapping
