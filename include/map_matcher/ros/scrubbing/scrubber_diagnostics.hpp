/// \file
/// The lidar_scrubber's health on /diagnostics.
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "map_matcher/ros/common/callback_guard.hpp"
#include "map_matcher/ros/common/diagnostic_report.hpp"
#include "map_matcher/ros/scrubbing/reference_veto.hpp"
#include "map_matcher/scrubbing/detector_watch.hpp"
#include "map_matcher/scrubbing/people_removal.hpp"

namespace map_matcher::ros_scrubbing {

/// What happened to the scans and detections.
struct ScanRecord {
  scrubbing::Stamp last_scan{0};   ///< Arrival of the last scan, by ROS's clock; zero: none yet.
  std::int64_t scans = 0;          ///< Scans that came.
  std::int64_t dropped = 0;        ///< Scans that made no sense.
  std::int64_t withheld = 0;       ///< Scans dropped since people might be in them (on_silence: drop).
  std::int64_t too_much = 0;       ///< Scans passed as they were since too much would have been removed.
  std::int64_t timed_out = 0;      ///< Scans that waited in vain for their detections (mode: synchronised).
  std::int64_t removed_beams = 0;  ///< Beams removed from all scans.
  std::size_t last_removed = 0;    ///< Beams removed from the last scan.
  std::string last_problem;        ///< Why the last dropped scan was.
  std::int64_t with_veto = 0;      ///< Messages of detections that were compared with the walls of the reference map.
  std::int64_t without_veto = 0;   ///< Those that could not be.
  std::int64_t failures = 0;       ///< Callbacks that failed.
  /// Sets of detections that were used, or could not be (kNone), by the way they came into the scan's frame.
  scrubbing::PeopleRemoval::PathCounts paths{};
};

/// What ScrubberDiagnostics looks at; all of it must outlive that.
struct ScrubberState {
  const ScanRecord& scans;
  const scrubbing::DetectorWatch& detectors;
  const scrubbing::PeopleRemoval& removal;
  const ReferenceVeto& veto;
  const ros_common::CallbackGuard& guard;
};

/// Once a second, by the wall clock, tells of scans, of what was removed, of the wall veto and of each detector.
/// Nothing is told to be well that is not at work: without scans, without a detector that serves, or without the
/// transforms between them, also while nobody is there to be removed.
class ScrubberDiagnostics {
 public:
  ScrubberDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const ScrubberState& state);

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void reportScans(Status& status);
  void reportScrubbing(Status& status);
  void summarizeScrubbing(Status& status) const;
  void reportVeto(Status& status) const;
  void reportDetector(const std::string& topic, Status& status);
  void summarizeDetector(const scrubbing::DetectorRecord& record, Status& status) const;
  std::optional<scrubbing::PosePath> pathOf(const scrubbing::DetectorRecord& record) const;

  /// Something counted since the last report.
  struct Rate {
    std::int64_t count = 0;
    ros::WallTime time = ros::WallTime::now();

    double update(std::int64_t new_count);
  };

  const ScrubberState state_;
  ScanRecord now_;   // of this report
  ScanRecord last_;  // of the last report
  Rate scan_rate_;
  std::map<std::string, Rate> detector_rates_;
  ros_common::DiagnosticReport report_;
};

}  // namespace map_matcher::ros_scrubbing
