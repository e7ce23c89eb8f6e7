// Removes the points near people from scans, in the process of a nodelet manager.

#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <stdexcept>

#include "map_matcher/ros/common/run_node.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server.hpp"

namespace map_matcher {

class LidarScrubberNodelet : public nodelet::Nodelet {
  // Throws when a parameter cannot be used; the manager then refuses to load the nodelet.
  void onInit() override {
    ros_scrubbing::LidarScrubberServerOptions options;
    if (!ros_common::loadParameters(getPrivateNodeHandle(), parametersOf(options))) {
      throw std::invalid_argument("lidar_scrubber: parameters that cannot be used, see above");
    }
    server_ = std::make_unique<ros_scrubbing::LidarScrubberServer>(getNodeHandle(), getPrivateNodeHandle(), options);
  }

  std::unique_ptr<ros_scrubbing::LidarScrubberServer> server_;
};

}  // namespace map_matcher

PLUGINLIB_EXPORT_CLASS(map_matcher::LidarScrubberNodelet, nodelet::Nodelet)
