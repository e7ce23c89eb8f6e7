/// \file
/// Knows whether the person detectors are alive.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher::scrubbing {

/// How well a detector does.
enum class DetectorHealth {
  kAlive,    ///< Heard of lately.
  kQuiet,    ///< Silent for longer than silence_warning.
  kSilent,   ///< Silent for longer than silence_error.
  kTooLate,  ///< For longer than silence_warning all that it said came when it no longer applied to any scan.
};

/// What is known of one detector. Times are those of the clock that stamps.
struct DetectorRecord {
  Stamp last_heard{0};            ///< Arrival of the last message; zero: none yet.
  std::int64_t messages = 0;      ///< Messages that could be read.
  std::int64_t detections = 0;    ///< Detections that were used.
  std::int64_t left_out = 0;      ///< Detections that applyLimits() left out.
  std::int64_t on_walls = 0;      ///< Detections that the reference map vetoed.
  std::int64_t bad_messages = 0;  ///< Messages that could not be used.
  std::string last_problem;       ///< Why the last of them could not.
  double last_delay = 0.0;        ///< [s] Stamp of the newest scan at the arrival, less the detections' stamp.
  std::string frame;              ///< Of the last message.
  Stamp stamp{0};                 ///< Of the last message.

  bool has_served = false;             ///< Whether a message applied to a scan since the watch began.
  bool last_has_served = false;        ///< Whether the last message did.
  std::optional<Stamp> useless_since;  ///< When the first of the messages since that did not was found out.
};

/// What a detector may do; the fields as in LidarScrubberServerOptions and CacheOptions.
struct DetectorLimits {
  double silence_warning = 1.0;  ///< [s]
  double silence_error = 5.0;    ///< [s]
  double cache_duration = 0.25;  ///< [s]
};

/// Records of all detectors, by topic. A detector is silent since its last message, or since the watch began. An empty
/// message is no silence: nobody is there. Detections that come when the scans that they apply to are gone help nobody:
/// a detector whose detections all do is as good as silent.
class DetectorWatch {
 public:
  DetectorWatch(const std::vector<std::string>& topics, const DetectorLimits& limits);

  /// What counts from now on.
  void setLimits(const DetectorLimits& limits) { limits_ = limits; }

  /// Begins anew, as when time goes back.
  void restart(Stamp now);

  /// A message, also an empty one, made from a scan of this stamp has come.
  void onDetections(const DetectionSet& set, Stamp now);

  /// A scan goes out, without the people that are known by now.
  void onScan(Stamp scan_stamp, Stamp now);

  DetectorRecord& record(const std::string& topic) { return records_.at(topic); }
  const std::map<std::string, DetectorRecord>& records() const { return records_; }

  /// [s] 0 while time is zero.
  double silence(const DetectorRecord& record, Stamp now) const;

  /// [s] For how long nothing that the detector said applied to a scan; 0 when the last that could did.
  static double lateness(const DetectorRecord& record, Stamp now);

  DetectorHealth health(const DetectorRecord& record, Stamp now) const;

  /// Topics of the detectors that do not serve: silent, or all too late, for longer than silence_error, or without
  /// anything that applied to a scan since the watch began.
  std::vector<std::string> uselessTopics(Stamp now) const;

 private:
  DetectorLimits limits_;
  Stamp start_{0};
  std::map<std::string, DetectorRecord> records_;
};

}  // namespace map_matcher::scrubbing
