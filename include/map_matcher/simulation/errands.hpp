/// \file
/// Where people walk to.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/simulation/path_planner.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/way_field.hpp"

namespace map_matcher::simulation {

/// Random places of a building that many people walk to, and the ways there.
class Errands {
 public:
  /// `planner` must outlive the errands, and has places.
  Errands(const PathPlanner& planner, RandomNumbers& random);

  /// Number of a random goal, one of the nearer ones where there are such: people who cross the whole building would
  /// all meet in its middle.
  std::size_t randomGoal(const Eigen::Vector2d& position, RandomNumbers& random) const;

  /// Where a goal is [m].
  const Eigen::Vector2d& placeOf(std::size_t goal) const { return goals_[goal]; }

  /// The ways to a goal; planned when somebody first goes there.
  const WayField& waysTo(std::size_t goal);

 private:
  const PathPlanner& planner_;
  std::vector<Eigen::Vector2d> goals_;
  std::vector<std::optional<WayField>> ways_;
};

}  // namespace map_matcher::simulation
