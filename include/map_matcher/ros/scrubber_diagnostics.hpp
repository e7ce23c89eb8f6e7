/// \file
/// The lidar_scrubber's health on /diagnostics.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <map>
#include <string>

#include "map_matcher/ros/detector_watch.hpp"
#include "map_matcher/ros/people_removal.hpp"

namespace map_matcher {

/// What happened to the scans.
struct ScanRecord {
  ros::Time last_scan;             ///< Arrival of the last scan; zero: none yet.
  std::int64_t scans = 0;          ///< Scans that came.
  std::int64_t dropped = 0;        ///< Scans that made no sense.
  std::int64_t withheld = 0;       ///< Scans dropped since a detector was silent (on_silence: drop).
  std::int64_t too_much = 0;       ///< Scans passed as they were since too much would have been removed.
  std::int64_t timed_out = 0;      ///< Scans that waited in vain for their detections (mode: synchronised).
  std::int64_t removed_beams = 0;  ///< Beams removed from all scans.
  std::size_t last_removed = 0;    ///< Beams removed from the last scan.
  std::string last_problem;        ///< Why the last dropped scan was.
  /// Sets of detections that were used, or could not be (kNone), by the way they came into the scan's frame.
  PeopleRemoval::PathCounts paths{};
};

/// Once a second, by the wall clock, tells of scans, of what was removed, and of each detector.
class ScrubberDiagnostics {
 public:
  /// The records must outlive this.
  ScrubberDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const ScanRecord& scans,
                      const DetectorWatch& detectors);

 private:
  void reportScans(diagnostic_updater::DiagnosticStatusWrapper& status);
  void reportScrubbing(diagnostic_updater::DiagnosticStatusWrapper& status);
  void reportDetector(const std::string& topic, diagnostic_updater::DiagnosticStatusWrapper& status);

  /// Something counted since the last report.
  struct Rate {
    std::int64_t count = 0;
    ros::WallTime time = ros::WallTime::now();

    double update(std::int64_t new_count);
  };

  const ScanRecord& scans_;
  const DetectorWatch& detectors_;
  ScanRecord last_scans_;  // at the last report
  Rate scan_rate_;
  std::map<std::string, Rate> detector_rates_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace map_matcher
