// Matches session maps to the reference map and broadcasts how they lie in it.

#include "map_matcher/ros/map_matcher_server.hpp"
#include "map_matcher/ros/names.hpp"
#include "map_matcher/ros/run_node.hpp"

int main(int argc, char** argv) {
  return map_matcher::runNode<map_matcher::MapMatcherServer, map_matcher::MapMatcherServerOptions>(
      argc, argv, map_matcher::names::kNode);
}
