// Matches session maps to the reference map and broadcasts how they lie in it.

#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/matching/map_matcher_server.hpp"

int main(int argc, char** argv) {
  return map_matcher::ros_common::runNode<map_matcher::ros_matching::MapMatcherServer,
                                          map_matcher::ros_matching::MapMatcherServerOptions>(
      argc, argv, map_matcher::ros_common::names::kNode);
}
