/// \file
/// Distances between cells, and of cells of walls from what is no wall, as cv::distanceTransform has them with
/// DIST_MASK_5, where few cells are walls: without looking at all others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/grid/grid_geometry.hpp"

namespace map_matcher::grid {

/// The cells within `distance` [cells] of a cell, row by row: how far the row reaches to either side of it. The middle
/// one is its own row; rows that are too far off are left out.
std::vector<int> chamferDisc(double distance);

/// How deep cells lie in walls: how far each is from the nearest cell that is no wall. What lies beyond the grid counts
/// as wall.
class ChamferDepths {
 public:
  /// `walls` are those of a grid of width x height cells, each once. Depths are told up to `deepest` [cells].
  ChamferDepths(const std::vector<Cell>& walls, double deepest, int width, int height);

  /// Depth of a cell [cells]: 0 where there is no wall; infinite where it is more than `deepest`.
  double at(const Cell& cell) const { return depths_[ranks_[index(cell)]]; }

  /// The largest depth of the cell and the eight around it.
  double deepestAround(const Cell& cell) const;

 private:
  std::uint16_t infinite() const { return static_cast<std::uint16_t>(depths_.size() - 1); }
  void rankByTransform(const std::vector<Cell>& walls);

  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(cell.x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<double> depths_;        // all that there are, in rising order; the first is 0, the last infinite
  std::vector<std::uint16_t> ranks_;  // in depths_, of each cell, row-major
};

}  // namespace map_matcher::grid
