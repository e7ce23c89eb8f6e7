#include "map_matcher/ros/common/run_node.hpp"

#include <ros/console.h>
#include <ros/init.h>

#include <csignal>
#include <string>

#include "map_matcher/ros/common/parameter_reader.hpp"

namespace map_matcher::ros_common {

bool loadParameters(const ros::NodeHandle& private_node, const parameters::ParameterList& parameters) {
  const std::vector<std::string> problems = readParameters(private_node, parameters);
  for (const std::string& problem : problems) {
    ROS_ERROR_STREAM(problem);
  }
  for (const std::string& unknown : unknownParameters(private_node, parameters)) {
    ROS_WARN_STREAM(unknown);
  }
  return problems.empty();
}

void shutDownOnTerm() {
  std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });
}

void logFatal(const std::exception& error) { ROS_FATAL_STREAM(error.what()); }

}  // namespace map_matcher::ros_common
