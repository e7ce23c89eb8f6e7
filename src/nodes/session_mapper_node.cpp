// Draws a session map from scans and odometry, with slam_gmapping's topics, frames and parameters.

#include "map_matcher/ros/run_node.hpp"
#include "map_matcher/ros/session_mapper_server.hpp"

int main(int argc, char** argv) {
  return map_matcher::runNode<map_matcher::SessionMapperServer, map_matcher::SessionMapperServerOptions>(
      argc, argv, "session_mapper");
}
