/// \file
/// How fast simulated time passes.
#pragma once

#include <chrono>
#include <optional>

namespace map_matcher::ros_common {

/// Tells when simulated instants are due, so that simulated time passes `real_time_factor` times as fast as real time.
/// Who is late by up to 0.2 s makes up for it. Who is later than that never does: simulated time falls behind, and
/// what was late already does not make the rest hurry.
class Pacing {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// `real_time_factor`: 0 means that everything is due at once.
  explicit Pacing(double real_time_factor) : real_time_factor_(real_time_factor) {}

  /// When the instant is due that comes `advance` [s] of simulated time, 0 or more, after the last one asked for; the
  /// first is counted from `now`, the present real time. May be past.
  TimePoint dueAfter(double advance, const TimePoint& now);

  /// Real time that simulated time has fallen behind for good [s].
  double lost() const { return lost_; }

 private:
  double real_time_factor_;
  std::optional<TimePoint> due_;
  double lost_ = 0.0;
};

}  // namespace map_matcher::ros_common
