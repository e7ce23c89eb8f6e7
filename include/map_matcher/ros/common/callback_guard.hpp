/// \file
/// Keeps what a callback throws from ending the process.
#pragma once

#include <ros/console.h>

#include <cstdint>
#include <exception>
#include <string>

namespace map_matcher::ros_common {

/// The door of a node's callbacks: a nodelet that let an exception out would take its manager down, and with it the
/// driver of the lidar. What is thrown is told and counted. Not thread-safe.
class CallbackGuard {
 public:
  /// Calls `action()`, which is about `subject`, and returns whether it came to its end.
  template <typename Action>
  bool run(const std::string& subject, Action&& action) {
    try {
      action();
      return true;
    } catch (const std::exception& error) {
      fail(subject, error.what());
    } catch (...) {
      fail(subject, "something that is no std::exception");
    }
    return false;
  }

  /// Tells and counts a failure that was caught elsewhere.
  void fail(const std::string& subject, const std::string& what) {
    ++failures_;
    last_failure_ = subject + ": " + what;
    ROS_ERROR_STREAM_THROTTLE(5.0, last_failure_ << " (" << failures_ << " failures so far)");
  }

  std::int64_t failures() const { return failures_; }
  const std::string& lastFailure() const { return last_failure_; }  ///< Empty: none.

 private:
  std::int64_t failures_ = 0;
  std::string last_failure_;
};

}  // namespace map_matcher::ros_common
