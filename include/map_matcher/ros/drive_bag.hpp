/// \file
/// Writes a simulated drive as the bag that a robot would have recorded.
#pragma once

#include <stdexcept>
#include <string>

#include "map_matcher/simulation/drive.hpp"

namespace map_matcher {

/// A bag that cannot be written; the text names the file and the reason.
class DriveBagError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Names in the bag.
struct DriveBagOptions {
  double start_stamp = 1000.0;                ///< [s] Of the first message, from 1 to 4e9; never the time of writing.
  std::string scan_topic = "/scan";           ///< sensor_msgs/LaserScan
  std::string odometry_topic = "/odom";       ///< nav_msgs/Odometry
  std::string truth_topic = "/ground_truth";  ///< geometry_msgs/PoseStamped, the base in the map frame.
  std::string map_frame = "map";              ///< Frame of the map that was driven in.
  std::string odometry_frame = "odom";
  std::string base_frame = "base_link";
  std::string lidar_frame = "laser";
};

/// Writes the bag, replacing the file. Every step of the drive gives four messages with the step's stamp, which arrive
/// in this order: /tf with both odometry_frame -> base_frame and base_frame -> lidar_frame (the fixed mounting is
/// repeated, so that a replay may begin anywhere), odometry and ground truth 1 ms later, and the scan 2 ms later, when
/// its transform is known. Messages of the same drive are the same byte for byte. Throws DriveBagError when the file
/// cannot be written or start_stamp is out of its range.
void writeDriveBag(const Drive& drive, const std::string& path, const DriveBagOptions& options = {});

}  // namespace map_matcher
