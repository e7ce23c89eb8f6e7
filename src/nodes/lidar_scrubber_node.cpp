// Removes the points near people from scans, as a process of its own.

#include "map_matcher/ros/lidar_scrubber_server.hpp"
#include "map_matcher/ros/run_node.hpp"

int main(int argc, char** argv) {
  return map_matcher::runNode<map_matcher::LidarScrubberServer, map_matcher::LidarScrubberServerOptions>(
      argc, argv, "lidar_scrubber");
}
