/// \file
/// A map as something that rays meet and robots bump into.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::simulation {

/// The solid squares of an occupancy grid. Immutable; may be read from several threads.
///
/// Occupied cells are solid. Unknown cells are no walls, as everywhere in this package: rays pass through them, but
/// nobody drives there. Beyond the grid there is nothing to meet and no place to drive.
class World {
 public:
  /// `occupied_threshold` [percent, 1 to 100]: value from which a cell is solid. Throws std::invalid_argument for a
  /// threshold out of range.
  explicit World(const grid::OccupancyGrid& grid, std::int8_t occupied_threshold = grid::kDefaultOccupiedThreshold);

  const grid::GridGeometry& geometry() const { return geometry_; }

  /// Distance [m] from a point of the map frame to where a ray of this heading [rad] enters the first solid cell: 0 in
  /// a solid cell, infinity when it meets none within `range_max` [m] or starts outside the grid. Exact but for
  /// rounding. Throws std::invalid_argument for numbers that are not finite.
  double castRay(const Eigen::Vector2d& p_map, double heading, double range_max) const;

  /// A lower bound of the distance [m] from a point of the map frame to the nearest place where nobody drives: solid,
  /// unknown or outside the grid; 0 in such a place. At most 1.7 cells less than the true distance.
  double clearance(const Eigen::Vector2d& p_map) const;

  /// Whether a circle of this radius [m] around a point of the map frame holds nothing but free cells; exact. False
  /// outside the grid.
  bool isClear(const Eigen::Vector2d& p_map, double radius) const;

 private:
  bool isBlocked(int x, int y) const { return free_space_[paddedIndex(x, y)] == 0.0F; }
  std::size_t paddedIndex(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(padded_width_) + static_cast<std::size_t>(x);
  }
  Eigen::Vector2d toCells(const Eigen::Vector2d& p_map) const;
  bool isInside(const Eigen::Vector2d& p) const;
  double clearanceIn(const Eigen::Vector2d& p) const;
  void measureStrides(const grid::OccupancyGrid& grid, std::int8_t occupied_threshold);
  void measureFreeSpace(const grid::OccupancyGrid& grid, std::int8_t occupied_threshold);

  grid::GridGeometry geometry_;
  grid::Rigid2 T_grid_map_;
  Eigen::Matrix2d rotation_;           // of T_grid_map, which would be computed for every point
  int padded_width_ = 0;               // the grid's width and a border of one cell on either side
  std::vector<std::uint8_t> strides_;  // per cell of the padded grid: see world.cpp
  std::vector<float> free_space_;      // per cell of the padded grid: centre to centre of the nearest blocked cell
};

}  // namespace map_matcher::simulation
