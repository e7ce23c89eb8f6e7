/// \file
/// What is known of the robot between two fixes.
#pragma once

#include "map_matcher/fixes/pose_estimate.hpp"

namespace map_matcher::fixes {

/// Follows the robot from a fix on, by its pose in the session map, and is less certain of it with every metre, turn
/// and second. The variances are those of ordinary wheel odometry, a standard deviation of 1 % of the distance and 0.6
/// degrees after a metre, and of 2 degrees after a full turn, and grow in proportion to the way: a mapper that corrects
/// its odometry is better than that. A robot that stands is taken for one that creeps at 1 mm/s. Not thread-safe.
class DeadReckoning {
 public:
  /// `fix` is where the robot was when its pose in the session map was `T_session_base`.
  DeadReckoning(const PoseEstimate& fix, const grid::Rigid2& T_session_base);

  /// The robot is there now. A `stamp` [s] before the last one is taken for that one.
  void moveTo(const grid::Rigid2& T_session_base, double stamp);

  /// Where the robot is after the last motion.
  PoseEstimate estimate() const;

 private:
  void grow(double distance, double turn);

  PoseEstimate counted_;  // up to here the covariance has grown
  grid::Rigid2 T_session_counted_;
  grid::Rigid2 T_session_base_;
  double stamp_ = 0.0;
};

}  // namespace map_matcher::fixes
