/// \file
/// The reference map as the exact search sees it: walls as thick as a hit may be off, pooled for blocks of poses.
#pragma once

#include <cstddef>
#include <vector>

#include "map_matcher/search/counting/block_shape.hpp"
#include "map_matcher/search/counting/precomputed_grids.hpp"

namespace map_matcher::search {

/// All levels of the exact search of a reference map of one resolution. Immutable, hence thread-safe.
class WidenedGrids {
 public:
  /// Widens the walls of a grid of width x height cells to discs: a cell is a hit when its centre lies within
  /// `tolerance` [cells, at least 0] of the centre of a wall; a tolerance beyond width + height counts as that. Hits
  /// beside the map count like those in it. Pools them for the levels 0 to `top_level`. Walls outside the grid are
  /// ignored. Throws std::invalid_argument for a size below 1 x 1, a tolerance that is negative or not finite, a level
  /// outside [0, BlockShape::kMaxLevel], or a map whose levels would take more than 2 GiB each, and DeadlinePassed
  /// when that comes before the end.
  WidenedGrids(int width, int height, const std::vector<grid::Cell>& walls, double tolerance, int top_level,
               const work::Deadline& deadline = work::Deadline());

  int topLevel() const { return static_cast<int>(levels_.size()) - 1; }

  /// Pooled walls for nodes of a level, in steps of BlockShape::grain() cells. The value at position(level, {x, y}),
  /// for multiples x and y of the grain, tells whether a hit lies in the window of BlockShape::window() cells that
  /// begins at (x, y).
  const PooledLevel& level(int level) const { return levels_[static_cast<std::size_t>(level)]; }
  grid::Cell position(int level, const grid::Cell& first) const;

  /// Smallest box of cells that holds all hits; without walls it is empty: last < first.
  const grid::Cell& firstHit() const { return first_hit_; }  ///< Lower left cell of the box.
  const grid::Cell& lastHit() const { return last_hit_; }    ///< Upper right cell of the box.
  std::size_t bytes() const;                                 ///< Memory taken [bytes].

 private:
  int shift(int level) const;

  int reach_;  // of the tolerance [cells]
  grid::Cell first_hit_;
  grid::Cell last_hit_;
  std::vector<PooledLevel> levels_;
};

}  // namespace map_matcher::search
