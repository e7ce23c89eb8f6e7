// Drives a simulated robot among people, live.

#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/simulation/crowd_simulator_server.hpp"

int main(int argc, char** argv) {
  return map_matcher::ros_common::runNode<map_matcher::ros_simulation::CrowdSimulatorServer,
                                          map_matcher::ros_simulation::CrowdSimulatorServerOptions>(argc, argv,
                                                                                                    "crowd_simulator");
}
