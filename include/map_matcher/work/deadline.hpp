/// \file
/// When a search has to end, whatever it has found by then.
#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::work {

/// Work was given up because its deadline passed.
class DeadlinePassed : public std::runtime_error {
 public:
  DeadlinePassed() : std::runtime_error("the deadline passed") {}
};

/// A point in time on a clock that never goes back, or whatever else its maker takes for the end, or a stop from
/// another thread. Once it has passed, it stays so. Thread-safe.
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

  /// Ends when `is_over` says so, for those who measure time, or work, in another way than by this clock. It is asked
  /// at every look at the deadline, thousands of times in a second and from several threads at once, and having said so
  /// it has to go on saying so.
  explicit Deadline(std::function<bool()> is_over, const StopToken& stop = {})
      : stop_(stop), limited_(false), is_over_(std::move(is_over)) {}

  const StopToken& stop() const { return stop_; }         ///< The token that ends it before its time.
  bool stopped() const { return stop_.stopRequested(); }  ///< Whether the stop token was set.

  /// Throws DeadlinePassed once it has passed: for what is of no use half done.
  void throwIfPassed() const {
    if (passed()) {
      throw DeadlinePassed();
    }
  }

  bool passed() const { return stopped() || (limited_ && Clock::now() >= end_) || (is_over_ && is_over_()); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kLongest = 1e9;  // [s] what a clock can hold

  StopToken stop_;
  bool limited_;
  Clock::time_point end_{};
  std::function<bool()> is_over_;
};

}  // namespace map_matcher::work
