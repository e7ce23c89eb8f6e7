/// \file
/// Knows whether the person detectors are alive.
#pragma once

#include <ros/time.h>

#include <map>
#include <string>
#include <vector>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher {

/// How well a detector does.
enum class DetectorHealth {
  kAlive,    ///< Heard of lately.
  kQuiet,    ///< Silent for longer than silence_warning.
  kSilent,   ///< Silent for longer than silence_error.
  kTooLate,  ///< Its last detections came when they no longer applied to any scan.
};

/// What is known of one detector.
struct DetectorRecord {
  ros::Time last_heard;           ///< Arrival of the last message; zero: none yet.
  std::int64_t messages = 0;      ///< Messages that could be read.
  std::int64_t detections = 0;    ///< Detections that were used.
  std::int64_t left_out = 0;      ///< Detections that applyLimits() left out.
  std::int64_t on_walls = 0;      ///< Detections that the reference map vetoed.
  std::int64_t bad_messages = 0;  ///< Messages that could not be used.
  std::string last_problem;       ///< Why the last of them could not.
  double last_delay = 0.0;        ///< [s] Stamp of the newest scan at the arrival, less the detections' stamp.
};

/// Records of all detectors, by topic. A detector is silent since its last message, or since the watch began. An empty
/// message is no silence: nobody is there.
class DetectorWatch {
 public:
  /// `cache_duration` [s] makes out what is too late; the other two as in LidarScrubberServerOptions.
  DetectorWatch(const std::vector<std::string>& topics, double silence_warning, double silence_error,
                double cache_duration);

  /// Begins anew, as when time goes back.
  void restart(const ros::Time& now);

  DetectorRecord& record(const std::string& topic) { return records_.at(topic); }
  const std::map<std::string, DetectorRecord>& records() const { return records_; }

  /// [s] 0 while time is zero.
  double silence(const DetectorRecord& record, const ros::Time& now) const;

  DetectorHealth health(const DetectorRecord& record, const ros::Time& now) const;

  /// Topics of the detectors that are silent.
  std::vector<std::string> silentTopics(const ros::Time& now) const;

  /// Whether every detector was heard of since the watch began.
  bool allHeard() const;

 private:
  double silence_warning_;
  double silence_error_;
  double cache_duration_;
  ros::Time start_;
  std::map<std::string, DetectorRecord> records_;
};

}  // namespace map_matcher
