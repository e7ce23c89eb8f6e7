// Removes the points near people from scans, in the process of a nodelet manager.

#include <pluginlib/class_list_macros.hpp>

#include "map_matcher/ros/scrubbing/lidar_scrubber_server.hpp"
#include "server_nodelet.hpp"

namespace map_matcher {

class LidarScrubberNodelet
    : public ServerNodelet<ros_scrubbing::LidarScrubberServer, ros_scrubbing::LidarScrubberServerOptions> {};

}  // namespace map_matcher

PLUGINLIB_EXPORT_CLASS(map_matcher::LidarScrubberNodelet, nodelet::Nodelet)
