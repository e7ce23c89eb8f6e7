/// \file
/// A smooth field of the distance to the nearest wall.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "map_matcher/search/precomputed_grids.hpp"

namespace map_matcher {

/// Half the squared distance to the nearest wall in a box of cells, smoothed over about a cell so that the steps of a
/// slanted wall even out. Unlike the distance it has no crease at the wall: its gradient is the way from the middle of
/// the wall, its curvature 1 across the wall and 0 along it. Positions are in cells of the grid, with the centre of
/// cell (0, 0) at (0.5, 0.5). Immutable, hence thread-safe.
class DistanceField {
 public:
  /// What the field is like at a position.
  struct Sample {
    Eigen::Vector2d gradient{0.0, 0.0};                   ///< Way from the nearest wall [cells].
    Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();  ///< Symmetric; as interpolated, it may be indefinite.
  };

  /// Field of the walls in the cells first ... last; walls beyond them do not count. Distances beyond `farthest`
  /// [cells] are all the same.
  DistanceField(const PrecomputedGrids& walls, const Cell& first, const Cell& last, double farthest);

  /// Sample at a position [cells], interpolated between cells; zero, as far away from all walls, beyond the box.
  Sample at(const Eigen::Vector2d& position) const;

 private:
  using Derivatives = Eigen::Matrix<double, 5, 1>;  // along x, y, xx, xy, yy

  /// Derivatives at the centre of a cell of the box that is not on its border.
  Derivatives derivativesAt(int column, int row) const;

  Cell first_;
  int width_;
  int height_;
  std::vector<float> values_;  // at the centres of the cells, row by row
};

}  // namespace map_matcher
