/// \file
/// The lidar_scrubber: scans in, scans without people out.
#pragma once

#include <map_matcher/LidarScrubberConfig.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/ros/common/callback_guard.hpp"
#include "map_matcher/ros/common/reconfiguration.hpp"
#include "map_matcher/ros/common/tf_transforms.hpp"
#include "map_matcher/ros/scrubbing/detection_subscriber.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"
#include "map_matcher/ros/scrubbing/reference_veto.hpp"
#include "map_matcher/ros/scrubbing/removal_display.hpp"
#include "map_matcher/ros/scrubbing/scrubber_diagnostics.hpp"
#include "map_matcher/scrubbing/detector_watch.hpp"
#include "map_matcher/scrubbing/people_removal.hpp"

namespace map_matcher::ros_scrubbing {

/// Removes the points near people from scans (report section 2.2): in `scan` (sensor_msgs/LaserScan) and the detection
/// topics; out `scan_scrubbed` (sensor_msgs/LaserScan), for people who look on `removed_points` and `removal_circles`,
/// and /diagnostics. A scan from which nothing is removed goes out as the very message that came in; of another, all
/// but the ranges of the removed beams is the same. All callbacks run on the one thread of the node handle's queue, and
/// none lets an exception out: a scan that cannot be scrubbed passes as it is, or is dropped with on_silence: drop.
class LidarScrubberServer {
 public:
  /// Throws std::invalid_argument, with the name and value of the option, when options contradict each other.
  LidarScrubberServer(ros::NodeHandle node, const ros::NodeHandle& private_node,
                      const LidarScrubberServerOptions& options);

 private:
  void onScan(const sensor_msgs::LaserScanConstPtr& scan);
  void onDetections(scrubbing::DetectionSet set);
  void onBadDetections(const std::string& topic, const std::string& reason);
  void onOptions(const LidarScrubberServerOptions& options);

  void takeScan(const sensor_msgs::LaserScanConstPtr& scan);
  std::optional<scrubbing::RawScan> usable(const sensor_msgs::LaserScanConstPtr& scan, scrubbing::Stamp now);
  void takeDetections(scrubbing::DetectionSet set);
  bool isFromTheFuture(scrubbing::DetectorRecord& record, const scrubbing::DetectionSet& set, scrubbing::Stamp now);

  void handOn(const sensor_msgs::LaserScanConstPtr& scan, const scrubbing::ScrubbedScan& scrubbed);
  bool isWithheld(const scrubbing::ScrubbedScan& scrubbed, scrubbing::Stamp now);
  void handOnAsItIs(const sensor_msgs::LaserScanConstPtr& scan);
  void withhold(const std::string& reason);
  void tellOf(const sensor_msgs::LaserScanConstPtr& scan, const scrubbing::ScrubbedScan& scrubbed);
  void tellOfPaths();

  LidarScrubberServerOptions options_;
  ros_common::CallbackGuard guard_;
  scrubbing::DetectorWatch detectors_;
  ScanRecord record_;

  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  ros_common::TfTransforms transforms_;
  scrubbing::DetectionPoses poses_;
  scrubbing::PeopleRemoval removal_;
  ReferenceVeto veto_;
  RemovalDisplay display_;
  ScrubberDiagnostics diagnostics_;
  ros::Publisher scan_publisher_;
  std::vector<std::unique_ptr<DetectionSubscriber>> detection_subscribers_;
  ros::Subscriber scan_subscriber_;
  ros::SteadyTimer waiting_timer_;
  ros_common::Reconfiguration<LidarScrubberConfig, LidarScrubberServerOptions> reconfiguration_;
};

}  // namespace map_matcher::ros_scrubbing
