/// \file
/// Where a robot goes that wants to see everything.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/simulation/lidar.hpp"
#include "map_matcher/simulation/path_planner.hpp"

namespace map_matcher::simulation {

/// Frontier exploration (Yamauchi: "A frontier-based approach for autonomous exploration", 1997; the report's section
/// 3.3.1): keeps what was seen in the cells of a planner's grid, and goes to the nearest place that was seen and lies
/// beside several that were not. Ways and places are the planner's, so nothing is looked for where nobody gets to.
class Exploration {
 public:
  /// `planner` must outlive the exploration. Nothing was seen yet.
  explicit Exploration(const PathPlanner& planner);

  /// Adds what a scan saw from its true pose, up to 8 m.
  void see(const scan::PlanarScan& scan, const grid::Rigid2& T_map_lidar);

  /// Whether something unseen lies beside this place [m], which was seen.
  bool isFrontier(const Eigen::Vector2d& place) const;

  /// The way to the nearest frontier; without those within 2 m of `avoided`. std::nullopt when there is none.
  std::optional<Path> nextWay(const Eigen::Vector2d& position, const std::optional<Eigen::Vector2d>& avoided) const;

 private:
  std::size_t indexOf(const grid::Cell& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(planner_.geometry().width) +
           static_cast<std::size_t>(cell.x);
  }

  const PathPlanner& planner_;
  std::vector<bool> seen_;  // cells of the planner's grid
};

}  // namespace map_matcher::simulation
