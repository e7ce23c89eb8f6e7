/// \file
/// Measures how long a step took, for reports only: no decision depends on it.
#pragma once

#include <chrono>

namespace map_matcher::work {

/// Time since construction or the last lap, on a clock that never goes back.
class Stopwatch {
 public:
  /// Seconds since construction or the last call of lap(); starts the next lap.
  double lap() {
    const auto now = Clock::now();
    const std::chrono::duration<double> elapsed = now - start_;
    start_ = now;
    return elapsed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace map_matcher::work
