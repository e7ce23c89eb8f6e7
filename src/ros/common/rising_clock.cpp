#include "map_matcher/ros/common/rising_clock.hpp"

namespace map_matcher::ros_common {

RisingClock::Tick RisingClock::tick(const ros::Time& now) {
  if (now.isZero()) {
    return Tick::kHeld;
  }
  if (now > last_) {
    last_ = now;
    return Tick::kAdvanced;
  }
  if ((last_ - now).toSec() > kTolerance) {
    last_ = now;
    return Tick::kWentBack;
  }
  return Tick::kHeld;
}

}  // namespace map_matcher::ros_common
