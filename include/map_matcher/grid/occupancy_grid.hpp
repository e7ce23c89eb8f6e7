/// \file
/// An occupancy grid with its geometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/grid/grid_geometry.hpp"

namespace map_matcher::grid {

/// Value of a cell that was never observed. It is a state of its own: neither free nor occupied.
constexpr std::int8_t kUnknown = -1;
/// Value of a cell that is certainly free.
constexpr std::int8_t kFree = 0;
/// Value of a cell that is certainly occupied.
constexpr std::int8_t kOccupied = 100;
/// A cell counts as a wall from this occupancy probability on [percent], as in map_server's occupied_thresh 0.65.
constexpr std::int8_t kDefaultOccupiedThreshold = 65;

/// Grid of occupancy probabilities [percent] with kUnknown for unobserved cells, row-major from the lower left cell, as
/// nav_msgs/OccupancyGrid has it. Immutable geometry; values are written through `at`.
class OccupancyGrid {
 public:
  /// Every cell unknown. Throws std::invalid_argument for a bad geometry.
  explicit OccupancyGrid(const GridGeometry& geometry);

  /// Takes the values as they are. Throws std::invalid_argument for a bad geometry, and when the number of values is
  /// not width x height or a value lies outside [-1, 100].
  OccupancyGrid(const GridGeometry& geometry, std::vector<std::int8_t> values);

  const GridGeometry& geometry() const { return geometry_; }
  int width() const { return geometry_.width; }               ///< [cells]
  int height() const { return geometry_.height; }             ///< [cells]
  double resolution() const { return geometry_.resolution; }  ///< [m]

  /// Value of a cell that lies inside the grid.
  std::int8_t at(int x, int y) const { return values_[index(x, y)]; }
  /// Writable value of a cell that lies inside the grid; the writer keeps it within [-1, 100].
  std::int8_t& at(int x, int y) { return values_[index(x, y)]; }

  /// All values, row-major from the lower left.
  const std::vector<std::int8_t>& values() const { return values_; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(geometry_.width) + static_cast<std::size_t>(x);
  }

  GridGeometry geometry_;
  std::vector<std::int8_t> values_;
};

}  // namespace map_matcher::grid
