/// \file
/// A clock whose ticks rise strictly, as tf needs its stamps to.
#pragma once

#include <ros/time.h>

namespace map_matcher::ros_common {

/// Tells what became of the time since the last tick: tf takes no stamp twice, and simulated time stands still, is zero
/// before the first /clock, and starts again when a bag loops.
class RisingClock {
 public:
  enum class Tick {
    kHeld,      ///< Time is zero or not later than at the last tick that advanced.
    kAdvanced,  ///< Time is later than at the last tick that advanced.
    kWentBack,  ///< Time is more than kTolerance earlier: it starts anew from here.
  };

  /// Time that goes back less is waited for: clocks are set right a little now and then [s].
  static constexpr double kTolerance = 1.0;

  Tick tick(const ros::Time& now);

 private:
  ros::Time last_;
};

}  // namespace map_matcher::ros_common
