/// \file
/// The ways of many people to one place.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "map_matcher/grid/grid_geometry.hpp"

namespace map_matcher::simulation {

/// For every cell of a planning grid the next cell on the cheapest way to one goal: planned once, followed by anybody
/// from anywhere, also by somebody who was pushed off the way. Made by PathPlanner::waysTo. Immutable.
class WayField {
 public:
  /// In place of the index of a next cell: no way leads from here.
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// `next`: for each cell, row-major, the index of the next, one of its eight neighbours; the goal's own for the goal.
  WayField(const grid::GridGeometry& geometry, const std::vector<std::uint32_t>& next);

  /// The next `length` [m] of the way from a point of the map frame, as centres of cells [m]: one or more, beginning
  /// with the nearest cell within two cells of the point; none when no way leads from there. Ends at the goal.
  std::vector<Eigen::Vector2d> ahead(const Eigen::Vector2d& p_map, double length) const;

 private:
  std::optional<grid::Cell> cellNear(const Eigen::Vector2d& p_map) const;
  std::size_t indexOf(const grid::Cell& cell) const;
  Eigen::Vector2d centreOf(const grid::Cell& cell) const;

  grid::GridGeometry geometry_;
  Eigen::Matrix2d map_from_grid_;  // rotation of T_map_grid, which would be computed for every cell
  grid::Rigid2 T_grid_map_;
  Eigen::Matrix2d grid_from_map_;    // rotation of T_grid_map
  std::vector<std::uint8_t> steps_;  // per cell: where the next is, see way_field.cpp
};

}  // namespace map_matcher::simulation
