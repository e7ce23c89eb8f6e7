// Drives a simulated robot among people, live.

#include "map_matcher/ros/crowd_simulator_server.hpp"
#include "map_matcher/ros/run_node.hpp"

int main(int argc, char** argv) {
  return map_matcher::runNode<map_matcher::CrowdSimulatorServer, map_matcher::CrowdSimulatorServerOptions>(
      argc, argv, "crowd_simulator");
}
