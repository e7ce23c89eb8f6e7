/// \file
/// Holds scans back until their detections are there.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "map_matcher/scrubbing/scrubbed_scan.hpp"

namespace map_matcher::scrubbing {

/// Scans of the mode synchronised, in the order in which they came; none overtakes another. Times are those of a clock
/// that never goes back.
class WaitingScans {
 public:
  /// A scan that may go.
  struct Released {
    RawScan scan;
    HandOn hand_on;         ///< As it was given.
    bool answered = false;  ///< Whether its detections came; false: it waited long enough.
  };

  /// `timeout`: how long a scan waits.
  explicit WaitingScans(Stamp timeout) : timeout_(timeout) {}

  void add(RawScan scan, Stamp now, HandOn hand_on);

  /// Detections made from a scan of this frame and stamp have come, maybe before the scan.
  void onDetections(const std::string& frame, Stamp stamp);

  /// The oldest one if it may go at `now`; it waits no longer.
  std::optional<Released> release(Stamp now);

 private:
  struct Waiting {
    RawScan scan;
    HandOn hand_on;
    Stamp deadline;
  };
  struct Answer {
    std::string frame;
    Stamp stamp{0};
  };

  bool isAnswered(const RawScan& scan) const;

  Stamp timeout_;
  std::deque<Waiting> waiting_;
  std::deque<Answer> answers_;  // the last ones
};

}  // namespace map_matcher::scrubbing
