/// \file
/// When a search has to end, whatever it has found by then.
#pragma once

#include <chrono>
#include <limits>

#include "map_matcher/search/stop_token.hpp"

namespace map_matcher {

/// A point in time on a clock that never goes back, or a stop from another thread. Thread-safe.
class Deadline {
 public:
  /// Ends `seconds` from now, at once when that is 0 or less or not a number, and never when it is infinite.
  explicit Deadline(double seconds = std::numeric_limits<double>::infinity(), const StopToken& stop = {})
      : stop_(stop), limited_(seconds <= kLongest), end_(Clock::now()) {
    if (limited_ && seconds > 0.0) {
      end_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    }
    limited_ = limited_ || seconds != seconds;
  }

  bool stopped() const { return stop_.stopRequested(); }  ///< Whether the stop token was set.
  bool passed() const { return stopped() || (limited_ && Clock::now() >= end_); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kLongest = 1e9;  // [s] what a clock can hold

  StopToken stop_;
  bool limited_;
  Clock::time_point end_;
};

}  // namespace map_matcher
