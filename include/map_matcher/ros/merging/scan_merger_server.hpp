/// \file
/// The scan_merger: the scans of several lasers in, one scan out.
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/ros/common/callback_guard.hpp"
#include "map_matcher/ros/common/diagnostic_report.hpp"
#include "map_matcher/ros/merging/scan_merger_server_options.hpp"

namespace map_matcher::ros_merging {

/// Merges the scans of several lasers into one, for a mapper that reads one topic, as slam_gmapping does: in the topics
/// of `scan_topics` (sensor_msgs/LaserScan) and tf fixed_frame <- base_frame <- laser; out `merged_scan`
/// (sensor_msgs/LaserScan) in base_frame, one for each scan of the leading laser, with its stamp, and /diagnostics.
/// Each beam counts where its laser was when it measured (time_increment). Scans that came too early or late for the
/// others are merged by their own poses; a laser that is silent is left out, and told. All callbacks run on the one
/// thread of the node handle's queue, and none lets an exception out.
class ScanMergerServer {
 public:
  /// Throws std::invalid_argument, with the name and value of the option, when one cannot be used.
  ScanMergerServer(ros::NodeHandle node, const ros::NodeHandle& private_node, const ScanMergerServerOptions& options);

 private:
  using ScanPtr = sensor_msgs::LaserScanConstPtr;
  using Set = scan::ScanSets<ScanPtr>::Set;

  /// What is known of a laser.
  struct Laser {
    std::int64_t scans = 0;
    std::int64_t merged = 0;
    std::int64_t refused = 0;
    double last_merged = 0.0;  ///< Stamp [s] of the merged scan that it had a part in last.
    bool silent = false;       ///< As was told.
    std::string last_problem;
  };

  void onScan(std::size_t laser, const ScanPtr& scan);
  void work();
  bool merge(const Set& set, bool is_late);
  std::optional<scan::MovingScan> placed(const sensor_msgs::LaserScan& scan, const ros::Time& target);
  void tellOfSilence(const Set& set);
  void tellWhatIsMissing();
  void reportLaser(std::size_t laser, diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void reportMerging(diagnostic_updater::DiagnosticStatusWrapper& status);

  const ScanMergerServerOptions options_;
  ros_common::CallbackGuard guard_;
  scan::ScanSets<ScanPtr> sets_;
  std::optional<Set> pending_;  // waits for tf
  std::vector<Laser> lasers_;
  std::int64_t published_ = 0;
  std::int64_t published_at_last_report_ = 0;
  std::int64_t dropped_ = 0;
  std::string tf_problem_;

  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  ros::Publisher publisher_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer work_timer_;
  ros::WallTimer waiting_timer_;
  ros_common::DiagnosticReport report_;
};

}  // namespace map_matcher::ros_merging
