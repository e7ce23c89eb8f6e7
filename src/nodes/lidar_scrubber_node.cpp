// Removes the points near people from scans, as a process of its own.

#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server.hpp"

int main(int argc, char** argv) {
  return map_matcher::ros_common::runNode<map_matcher::ros_scrubbing::LidarScrubberServer,
                                          map_matcher::ros_scrubbing::LidarScrubberServerOptions>(argc, argv,
                                                                                                  "lidar_scrubber");
}
