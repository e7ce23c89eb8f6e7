#include "map_matcher/ros/common/pacing.hpp"

namespace map_matcher::ros_common {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kMadeUp(0.2);  // of being late

}  // namespace

Pacing::TimePoint Pacing::dueAfter(double advance, const TimePoint& now) {
  if (real_time_factor_ == 0.0) {
    return now;
  }
  const auto real = std::chrono::duration_cast<TimePoint::duration>(Seconds(advance / real_time_factor_));
  due_ = due_.value_or(now) + real;
  const auto earliest = now - std::chrono::duration_cast<TimePoint::duration>(kMadeUp);
  if (*due_ < earliest) {
    lost_ += Seconds(earliest - *due_).count();
    due_ = earliest;
  }
  return *due_;
}

}  // namespace map_matcher::ros_common
