/// \file
/// Ways through the free space of a world.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/simulation/way_field.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// Points of the map frame [m], from start to goal.
using Path = std::vector<Eigen::Vector2d>;

/// Plans ways for a round robot by A* on a grid of about 10 cm. Longer ways through wide space are preferred to short
/// ones along walls.
class PathPlanner {
 public:
  /// `world` must outlive the planner. `required_clearance` [m]: no way comes nearer to anything; a robot's radius and
  /// a margin. Throws std::invalid_argument unless it is positive and finite.
  PathPlanner(const World& world, double required_clearance);

  /// A way between two points, or std::nullopt when there is none. Its first and last points are the given ones. The
  /// goal must have the required clearance; a start with less is left by a straight line to the nearest cell that has
  /// it.
  std::optional<Path> plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) const;

  /// The cheapest way to one of the places that `is_goal` names; std::nullopt when it names none that can be reached.
  std::optional<Path> planToNearest(const Eigen::Vector2d& start,
                                    const std::function<bool(const Eigen::Vector2d&)>& is_goal) const;

  /// The ways from everywhere to a goal with the required clearance; there are none from anywhere to another goal.
  WayField waysTo(const Eigen::Vector2d& goal) const;

  /// Area [m^2] that lies within the required clearance of the places: what somebody of this radius can cover.
  double coveredArea() const;

  /// Cells of the planning grid.
  const grid::GridGeometry& geometry() const { return geometry_; }

  /// Whether the required clearance is kept in the centre of a cell of the planning grid, which may lie outside it.
  bool isFree(const grid::Cell& cell) const { return geometry_.contains(cell) && costs_[indexOf(cell)] > 0.0F; }

  /// Centres of the cells to stand in that are connected with each other: the largest such region of the world. Empty
  /// when the robot fits nowhere.
  const std::vector<Eigen::Vector2d>& places() const { return places_; }

 private:
  /// What a search found.
  struct Search {
    std::vector<std::uint32_t> came_from;  // for each cell the index of the cell before it; WayField::kNone: not found
    std::optional<grid::Cell> reached;     // the goal
  };

  std::size_t indexOf(const grid::Cell& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(geometry_.width) +
           static_cast<std::size_t>(cell.x);
  }
  grid::Cell cellOf(std::size_t index) const;
  void measureCosts();
  void findPlaces();
  std::optional<grid::Cell> freeCellNear(const Eigen::Vector2d& p_map) const;
  template <typename IsGoal, typename CostToGo>
  Search explore(const grid::Cell& start, const IsGoal& is_goal, const CostToGo& cost_to_go) const;
  std::array<bool, 8> stepsFrom(const grid::Cell& cell) const;
  Path pathTo(const grid::Cell& reached, const grid::Cell& first, const std::vector<std::uint32_t>& came_from) const;

  const World& world_;
  double required_clearance_;
  grid::GridGeometry geometry_;  // of the planning grid
  std::vector<float> costs_;     // of a way through the cell, per length; 0: not to be entered
  std::vector<Eigen::Vector2d> places_;
};

}  // namespace map_matcher::simulation
