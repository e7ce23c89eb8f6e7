/// \file
/// Steps of a simulated drive as a trial takes them.
#pragma once

#include <vector>

#include "map_matcher/evaluation/trial.hpp"
#include "map_matcher/simulation/drive.hpp"

namespace map_matcher {

/// What the robot knew at a step, and the truth. `T_base_lidar`: mounting pose of each lidar.
TrialStep trialStepOf(const DriveStep& step, const std::vector<Rigid2>& T_base_lidar);

/// What the detector of a laser made of a scan; `laser` is its index.
TrialDetections trialDetectionsOf(const DetectedPeople& found, std::size_t laser);

/// What its detectors made of the scans of that step; to be added before the step, which may wait for it.
std::vector<TrialDetections> trialDetectionsOf(const DriveStep& step);

}  // namespace map_matcher
