/// \file
/// Differences of stamps.
#pragma once

#include <ros/time.h>

#include <cstdint>

namespace map_matcher::ros_common {

/// Time from one stamp to another [s], below 0 when that is the earlier one. Of any two stamps: what `-` makes of them
/// is a ros::Duration, and that throws when they are more than 68 years apart, as whatever a message holds may be.
inline double secondsBetween(const ros::Time& from, const ros::Time& to) {
  constexpr double kNanosecondsPerSecond = 1e9;
  return static_cast<double>(static_cast<std::int64_t>(to.toNSec()) - static_cast<std::int64_t>(from.toNSec())) /
         kNanosecondsPerSecond;
}

}  // namespace map_matcher::ros_common
