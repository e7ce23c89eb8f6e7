#include "map_matcher/evaluation/trajectory_error.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::evaluation {

PoseError errorOf(const grid::Rigid2& estimate, const grid::Rigid2& truth) {
  return {(estimate.translation() - truth.translation()).norm(),
          std::abs(grid::normalizeAngle(estimate.yaw - truth.yaw))};
}

std::optional<ErrorStatistics> statisticsOf(std::vector<double> errors) {
  if (errors.empty()) {
    return std::nullopt;
  }
  std::sort(errors.begin(), errors.end());
  const auto count = static_cast<double>(errors.size());
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (const double error : errors) {
    sum += error;
    sum_of_squares += error * error;
  }
  ErrorStatistics statistics;
  statistics.mean = sum / count;
  statistics.rms = std::sqrt(sum_of_squares / count);
  double variance = 0.0;
  for (const double error : errors) {
    variance += (error - statistics.mean) * (error - statistics.mean) / count;
  }
  statistics.standard_deviation = std::sqrt(variance);
  statistics.median = 0.5 * (errors[(errors.size() - 1) / 2] + errors[errors.size() / 2]);
  statistics.worst = errors.back();
  return statistics;
}

TrajectoryError evaluateTrajectory(const std::vector<PoseSample>& samples) {
  TrajectoryError result;
  std::vector<double> translations;
  std::vector<double> rotations;
  double worst = -1.0;
  for (const PoseSample& sample : samples) {
    if (!sample.estimate) {
      continue;
    }
    const PoseError error = errorOf(*sample.estimate, sample.truth);
    translations.push_back(error.translation);
    rotations.push_back(error.rotation);
    if (!result.time_to_first_estimate) {
      result.time_to_first_estimate = sample.time - samples.front().time;
    }
    if (error.translation > worst) {
      worst = error.translation;
      result.worst_time = sample.time;
    }
  }
  result.samples = static_cast<int>(samples.size());
  result.estimates = static_cast<int>(translations.size());
  result.translation = statisticsOf(std::move(translations));
  result.rotation = statisticsOf(std::move(rotations));
  return result;
}

}  // namespace map_matcher::evaluation
