/// \file
/// Writes a simulated drive as the bag that a robot would have recorded.
#pragma once

#include <rosbag/bag.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/simulation/drive.hpp"

namespace map_matcher {

/// A bag that cannot be written; the text names the file and the reason.
class DriveBagError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Names of one lidar in the bag.
struct LidarNames {
  std::string scan_topic = "/scan";                       ///< sensor_msgs/LaserScan
  std::string detections_topic = "/dr_spaam_detections";  ///< geometry_msgs/PoseArray, where the drive has people.
  std::string frame = "laser";
};

/// Names of this many lidars: those above of one; of two sick_laser_front and sick_laser_rear, as on the CROWDBOT
/// Pepper, with detections in /dr_spaam_detections/front and rear; of more /laser_1/scan and so on.
std::vector<LidarNames> lidarNames(std::size_t count);

/// Names in the bag.
struct DriveBagOptions {
  double start_stamp = 1000.0;                ///< [s] Of the first message, from 1 to 4e9; never the time of writing.
  double score_threshold = 0.4;               ///< Detections with a lower score are left out.
  std::string odometry_topic = "/odom";       ///< nav_msgs/Odometry
  std::string truth_topic = "/ground_truth";  ///< geometry_msgs/PoseStamped, the base in the map frame.
  std::string people_topic =
      "/people_truth";            ///< geometry_msgs/PoseArray, in the map frame, where the drive has people.
  std::string map_frame = "map";  ///< Frame of the map that was driven in.
  std::string odometry_frame = "odom";
  std::string base_frame = "base_link";
  std::vector<LidarNames> lidars;  ///< As many as the drive has lidars; empty: lidarNames().
};

/// What the messages of all steps share.
struct DriveDescription {
  std::vector<Rigid2> T_base_lidar;  ///< Mounting pose of each lidar.
  double period = 0.0;               ///< [s] Between two steps.
};

/// Writes a drive step by step, so that a long one need not fit into memory. Each step gives messages with its stamp,
/// which arrive in this order: /tf with odometry_frame -> base_frame and base_frame -> the frame of each lidar (the
/// fixed mounting is repeated, so that a replay may begin anywhere); 1 ms later odometry, ground truth and, with
/// people, where they are, with their headings; 2 ms later each scan, when its transform is known. Detections have the
/// stamp and frame of their scan and arrive with their detector's latency, 3 ms after the scan's stamp at the earliest;
/// as DR-SPAAM's their orientation is 0, 0, 0, 0, and an empty array tells that nobody is there. The same steps give
/// the same messages byte for byte.
class DriveBagWriter {
 public:
  /// Replaces the file. Throws DriveBagError when it cannot be written, start_stamp is out of its range or the number
  /// of names is not that of the lidars.
  DriveBagWriter(const std::string& path, DriveDescription drive, const DriveBagOptions& options = {});

  /// Adds the next step. Throws DriveBagError when it cannot be written.
  void write(const DriveStep& step);

  /// Completes the file, which cannot be read before. Throws DriveBagError when it cannot be written.
  void close();

 private:
  std::string path_;
  DriveDescription drive_;
  DriveBagOptions options_;
  rosbag::Bag bag_;
  std::uint32_t num_steps_ = 0;
};

/// Writes the whole drive, as DriveBagWriter does.
void writeDriveBag(const Drive& drive, const std::string& path, const DriveBagOptions& options = {});

}  // namespace map_matcher
