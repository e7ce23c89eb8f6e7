/// \file
/// A smooth field of the distance to the nearest wall.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "map_matcher/grid/grid_geometry.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// Half the squared distance to the nearest wall of a map, smoothed over about a cell so that the steps of a
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

  /// Field of the walls of a map of width x height cells; walls beyond them do not count. Distances beyond `farthest`
  /// [cells, at most 150 count] are all the same. Throws DeadlinePassed when that comes before the end.
  DistanceField(int width, int height, const std::vector<grid::Cell>& walls, double farthest,
                const work::Deadline& deadline = work::Deadline());

  std::size_t bytes() const { return values_.size() * sizeof(float); }  ///< Memory taken [bytes].

  /// Sample at a position [cells], interpolated between cells; zero, as far away from all walls, far beyond the map.
  Sample at(const Eigen::Vector2d& position) const;

 private:
  int border_;  // of the field around the map [cells]
  int width_;   // with border [cells]
  int height_;
  std::vector<float> values_;  // at the centres of the cells, row by row
};

}  // namespace map_matcher::search
