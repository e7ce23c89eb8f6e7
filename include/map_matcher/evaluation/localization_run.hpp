/// \file
/// The record of a run: where the robot was, where it was thought to be, and the last match.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/evaluation/trajectory_error.hpp"

namespace map_matcher {

/// A run, by its samples and its last accepted match.
struct LocalizationRun {
  std::vector<PoseSample> samples;            ///< In the order of time, poses in the reference map frame.
  std::optional<Rigid2> T_reference_session;  ///< Of the last accepted match; nullopt when there was none.
  double ratio = 0.0;                         ///< Of that match: share of the session cells on walls, 0 to 1.
};

/// Writes a line for each sample: its time since the first one [s], the true and the estimated pose [m, m, rad] and
/// the errors of the estimate [m, rad], which are left empty when there was none. Throws std::runtime_error.
void writeErrors(const LocalizationRun& run, const std::string& csv_path);

/// Writes the figures of a run as a JSON object. Its keys: samples, localized_samples, localized_after [s since the
/// first sample], transform {x, y, yaw} = T_reference_session [m, m, rad], ratio, translation_error [m] and
/// rotation_error [rad], each {mean, standard_deviation, median, rms, worst}, final_error {translation, rotation} of
/// the last estimate. What never came to be is null. Throws std::runtime_error.
void writeSummary(const LocalizationRun& run, const std::string& json_path);

}  // namespace map_matcher
