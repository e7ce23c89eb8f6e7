#include "map_matcher/ros/mapping/session_mapper_server_options.hpp"

namespace map_matcher::ros_mapping {

parameters::ParameterList parametersOf(SessionMapperServerOptions& options) {
  parameters::ParameterList parameters = parametersOf(options.mapping);
  parameters.push_back({"scan_topics", "",
                        "Topics of the scans, one for each laser of the robot, each of which stands where tf has its "
                        "frame.",
                        &options.scan_topics});
  parameters.push_back({"map_frame", "", "tf frame of the session map, the parent of odom_frame.", &options.map_frame});
  parameters.push_back({"transform_publish_period", "s",
                        "Time between two broadcasts of map_frame -> odom_frame; 0: none is broadcast.",
                        &options.transform_publish_period, 0.0, 10.0});
  parameters.push_back(
      {"tf_delay", "s", "How far into the future the broadcasts are stamped.", &options.tf_delay, 0.0, 10.0});
  return parameters;
}

}  // namespace map_matcher::ros_mapping
