/// \file
/// How far estimated poses are from the truth.
#pragma once

#include <optional>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::evaluation {

/// A pose at a time [s].
struct StampedPose {
  double time = 0.0;
  grid::Rigid2 pose;
};

/// The true pose at a time, and the estimate when there was one; both in the same frame.
struct PoseSample {
  double time = 0.0;                     ///< [s]
  grid::Rigid2 truth;                    ///< Where the robot was.
  std::optional<grid::Rigid2> estimate;  ///< Where it was thought to be.
};

/// Difference of an estimate from the truth, as magnitudes.
struct PoseError {
  double translation = 0.0;  ///< Distance [m].
  double rotation = 0.0;     ///< Smallest angle between the headings [rad], 0 to pi.
};

/// Distance and angle between two poses of the same frame.
PoseError errorOf(const grid::Rigid2& estimate, const grid::Rigid2& truth);

/// Figures of a set of errors, in the unit of the errors.
struct ErrorStatistics {
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< Of the population: divided by the number of errors.
  double median = 0.0;              ///< Mean of the two middle ones when their number is even.
  double rms = 0.0;                 ///< Root of the mean square.
  double worst = 0.0;               ///< The largest.
};

/// Figures of `errors`; nullopt when there are none.
std::optional<ErrorStatistics> statisticsOf(std::vector<double> errors);

/// What a run is worth (report table 1).
struct TrajectoryError {
  int samples = 0;                               ///< True poses.
  int estimates = 0;                             ///< Those with an estimate.
  std::optional<double> time_to_first_estimate;  ///< Since the first true pose [s].
  std::optional<double> worst_time;            ///< When the translation error was largest [s], as the samples have it.
  std::optional<ErrorStatistics> translation;  ///< [m], over the samples with an estimate.
  std::optional<ErrorStatistics> rotation;     ///< [rad], over the same.
};

/// Figures of a run. Samples are in the order of time.
TrajectoryError evaluateTrajectory(const std::vector<PoseSample>& samples);

}  // namespace map_matcher::evaluation
