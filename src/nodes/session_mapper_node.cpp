// Draws a session map from scans and odometry, with slam_gmapping's topics, frames and parameters.

#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/mapping/session_mapper_server.hpp"

int main(int argc, char** argv) {
  return map_matcher::ros_common::runNode<map_matcher::ros_mapping::SessionMapperServer,
                                          map_matcher::ros_mapping::SessionMapperServerOptions>(argc, argv,
                                                                                                "session_mapper");
}
