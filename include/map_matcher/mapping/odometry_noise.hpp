/// \file
/// How far odometry is believed.
#pragma once

#include <Eigen/Core>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::mapping {

/// Noise of the odometry, with slam_gmapping's names: the standard deviation after a metre of way and after a radian of
/// turning. Variances grow with way and turning, so that it does not matter how many scans they are divided among.
struct OdometryNoise {
  double srr = 0.1;   ///< [m] Of the way along itself, after a metre; beside it, kSidewaysShare of that.
  double srt = 0.05;  ///< [rad] Of the heading, after a metre.
  double str = 0.05;  ///< [m] Of the position, after turning a radian.
  double stt = 0.1;   ///< [rad] Of the heading, after turning a radian.
};

constexpr double kSidewaysShare = 0.3;  ///< Of srr, for a robot that drives straight on; slam_gmapping's.

/// A pose and how sure it is.
struct PoseEstimate {
  grid::Rigid2 T_session_base;
  /// Of x and y in the session frame [m] and of the heading [rad].
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The estimate after a motion that odometry measured, from base to base, which took `duration` [s]. A robot that
/// stands becomes a little less sure, too, so that a scan may tell what odometry does not.
PoseEstimate moved(const PoseEstimate& estimate, const grid::Rigid2& motion, double duration,
                   const OdometryNoise& noise);

}  // namespace map_matcher::mapping
