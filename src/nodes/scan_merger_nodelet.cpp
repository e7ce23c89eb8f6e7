// Merges the scans of several lasers into one, in the process of a nodelet manager.

#include <pluginlib/class_list_macros.hpp>

#include "map_matcher/ros/merging/scan_merger_server.hpp"
#include "server_nodelet.hpp"

namespace map_matcher {

class ScanMergerNodelet : public ServerNodelet<ros_merging::ScanMergerServer, ros_merging::ScanMergerServerOptions> {};

}  // namespace map_matcher

PLUGINLIB_EXPORT_CLASS(map_matcher::ScanMergerNodelet, nodelet::Nodelet)
