// Merges the scans of several lasers into one, as a process of its own.

#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/merging/scan_merger_server.hpp"

int main(int argc, char** argv) {
  return map_matcher::ros_common::runNode<map_matcher::ros_merging::ScanMergerServer,
                                          map_matcher::ros_merging::ScanMergerServerOptions>(argc, argv, "scan_merger");
}
