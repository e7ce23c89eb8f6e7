/// \file
/// Searches that are cut at a chosen look at their deadline.
#pragma once

#include <atomic>
#include <memory>

#include "map_matcher/work/deadline.hpp"
#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::test {

/// Ends a search at its n-th look at the deadline, counted over all threads.
class Cut {
 public:
  /// How the search is told.
  enum class Kind { kDeadline, kStop };

  explicit Cut(long look, Kind kind = Kind::kDeadline) : look_(look), kind_(kind) {}

  work::Deadline deadline() const {
    work::StopToken stop;
    const auto is_over = [looks = looks_, look = look_, kind = kind_, stop]() mutable {
      const bool over = ++*looks >= look;
      if (over && kind == Kind::kStop) {
        stop.requestStop();
      }
      return over;
    };
    return work::Deadline(is_over, stop);
  }

  /// Whether a search came that far.
  bool reached() const { return *looks_ >= look_; }

 private:
  long look_;
  Kind kind_;
  std::shared_ptr<std::atomic<long>> looks_ = std::make_shared<std::atomic<long>>(0);
};

}  // namespace map_matcher::test
