#include "map_matcher/simulation/errands.hpp"

namespace map_matcher::simulation {
namespace {

constexpr std::size_t kGoals = 96;  // of all people
constexpr double kErrand = 7.0;     // [m] to the next goal, at most, where there is one
constexpr int kGoalTrials = 20;     // goals that are looked at for one that is so near

}  // namespace

Errands::Errands(const PathPlanner& planner, RandomNumbers& random) : planner_(planner), ways_(kGoals) {
  while (goals_.size() < kGoals) {
    goals_.push_back(planner.places()[random.index(planner.places().size())]);
  }
}

std::size_t Errands::randomGoal(const Eigen::Vector2d& position, RandomNumbers& random) const {
  std::size_t goal = random.index(goals_.size());
  for (int i = 0; i < kGoalTrials && (goals_[goal] - position).norm() > kErrand; ++i) {
    goal = random.index(goals_.size());
  }
  return goal;
}

const WayField& Errands::waysTo(std::size_t goal) {
  if (!ways_[goal]) {
    ways_[goal] = planner_.waysTo(goals_[goal]);
  }
  return *ways_[goal];
}

}  // namespace map_matcher::simulation
