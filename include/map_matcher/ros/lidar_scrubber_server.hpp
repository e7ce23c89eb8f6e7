/// \file
/// The lidar_scrubber: scans in, scans without people out.
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>
#include <vector>

#include "map_matcher/ros/detection_subscriber.hpp"
#include "map_matcher/ros/detector_watch.hpp"
#include "map_matcher/ros/lidar_scrubber_server_options.hpp"
#include "map_matcher/ros/people_removal.hpp"
#include "map_matcher/ros/reference_veto.hpp"
#include "map_matcher/ros/removal_display.hpp"
#include "map_matcher/ros/scrubber_diagnostics.hpp"
#include "map_matcher/ros/waiting_scans.hpp"

namespace map_matcher {

/// Removes the points near people from scans (report section 2.2): in `scan` (sensor_msgs/LaserScan) and the detection
/// topics; out `scan_scrubbed` (sensor_msgs/LaserScan), for people who look on `removed_points` and `removal_circles`,
/// and /diagnostics. A scan from which nothing is removed goes out as the very message that came in; of another, all
/// but the ranges of the removed beams is the same. All callbacks run on the one thread of the node handle's queue.
class LidarScrubberServer {
 public:
  /// Throws std::invalid_argument, with the name and value of the option, when options contradict each other.
  LidarScrubberServer(ros::NodeHandle node, const ros::NodeHandle& private_node,
                      const LidarScrubberServerOptions& options);

 private:
  void onScan(const sensor_msgs::LaserScanConstPtr& scan);
  void onDetections(DetectionSet set);
  void onBadDetections(const std::string& topic, const std::string& reason);
  void releaseWaiting();

  bool isUsable(const sensor_msgs::LaserScan& scan, const ros::Time& now);
  bool isWithheld(const ros::Time& now);
  bool isFromTheFuture(DetectorRecord& record, const DetectionSet& set, const ros::Time& now);
  void scrub(const sensor_msgs::LaserScanConstPtr& scan);
  void tellOfPaths(const PeopleRemoval::PathCounts& before) const;

  const LidarScrubberServerOptions options_;
  WaitingScans waiting_scans_;
  DetectorWatch detectors_;
  ScanRecord record_;

  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  PeopleRemoval removal_;
  ReferenceVeto veto_;
  RemovalDisplay display_;
  ScrubberDiagnostics diagnostics_;
  ros::Publisher scan_publisher_;
  std::vector<std::unique_ptr<DetectionSubscriber>> detection_subscribers_;
  ros::Subscriber scan_subscriber_;
  ros::SteadyTimer waiting_timer_;
};

}  // namespace map_matcher
