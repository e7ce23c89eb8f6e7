/// \file
/// Steps of a simulated drive as a trial takes them.
#pragma once

#include <vector>

#include "map_matcher/simulation/drive.hpp"
#include "map_matcher/trials/trial.hpp"

namespace map_matcher::trials {

/// What the robot knew at a step, and the truth. `T_base_lidar`: mounting pose of each lidar.
TrialStep trialStepOf(const simulation::DriveStep& step, const std::vector<grid::Rigid2>& T_base_lidar);

/// What the detector of a laser made of a scan; `laser` is its index.
TrialDetections trialDetectionsOf(const simulation::DetectedPeople& found, std::size_t laser);

/// What its detectors made of the scans of that step; to be added before the step, which may wait for it.
std::vector<TrialDetections> trialDetectionsOf(const simulation::DriveStep& step);

}  // namespace map_matcher::trials
