#include "map_matcher/trials/simulated_trial.hpp"

namespace map_matcher::trials {

TrialStep trialStepOf(const simulation::DriveStep& step, const std::vector<grid::Rigid2>& T_base_lidar) {
  TrialStep trial_step{step.time, step.T_odom_base, step.T_map_base, {}};
  for (std::size_t i = 0; i < step.scans.size(); ++i) {
    trial_step.scans.push_back({step.scans[i], {T_base_lidar[i], false}});
  }
  return trial_step;
}

TrialDetections trialDetectionsOf(const simulation::DetectedPeople& found, std::size_t laser) {
  TrialDetections detections{found.time, found.arrival, laser, {}};
  for (const simulation::DetectedPerson& person : found.people) {
    detections.detections.push_back({{person.position.x(), person.position.y(), 0.0}, person.score});
  }
  return detections;
}

std::vector<TrialDetections> trialDetectionsOf(const simulation::DriveStep& step) {
  std::vector<TrialDetections> all;
  for (std::size_t laser = 0; laser < step.detections.size(); ++laser) {
    if (step.detections[laser]) {
      all.push_back(trialDetectionsOf(*step.detections[laser], laser));
    }
  }
  return all;
}

}  // namespace map_matcher::trials
