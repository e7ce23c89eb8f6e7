/// \file
/// Shows what was removed from a scan (report figure 2).
#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <vector>

#include "map_matcher/scrubbing/scan_scrubber.hpp"

namespace map_matcher::ros_scrubbing {

/// Publishes `removed_points` (sensor_msgs/PointCloud2) and `removal_circles` (visualization_msgs/Marker), each only
/// while somebody listens.
class RemovalDisplay {
 public:
  explicit RemovalDisplay(ros::NodeHandle node);

  /// `header` is the scan's; `beams` are those that were removed, of the last scan of the scrubber.
  void show(const std_msgs::Header& header, const scrubbing::ScanScrubber& scrubber,
            const std::vector<std::uint32_t>& beams, const std::vector<scrubbing::Disc>& discs);

 private:
  ros::Publisher points_;
  ros::Publisher circles_;
};

}  // namespace map_matcher::ros_scrubbing
