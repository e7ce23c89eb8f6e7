/// \file
/// The session cells under all rotations of the exact search, and under blocks of them.
#pragma once

#include <vector>

#include "map_matcher/search/counting/block_shape.hpp"
#include "map_matcher/search/counting/session_cells.hpp"
#include "map_matcher/search/counting/session_clusters.hpp"
#include "map_matcher/search/counting/weighted_cells.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// A row of rotations of a session, `step` apart. Immutable, hence thread-safe.
class RotationBlocks {
 public:
  /// Rotations first_angle + n * step, n = 0 ... count - 1 [rad]. The step moves no cell by more than half a cell, as
  /// that of eq. 4.2 with rotation_downsampling 1 does; else std::invalid_argument is thrown. Blocks of up to
  /// 2^top_level rotations are prepared, on `threads` threads. Throws DeadlinePassed when that comes before the end.
  RotationBlocks(const SessionCells& session, double first_angle, double step, int count, int top_level,
                 int threads = 1, const work::Deadline& deadline = work::Deadline());

  int count() const { return count_; }                                          ///< Number of rotations.
  double angle(int rotation) const { return first_angle_ + rotation * step_; }  ///< [rad]
  double step() const { return step_; }                                         ///< [rad]
  int numCells() const { return static_cast<int>(session_.points.size()); }     ///< [cells]

  /// Length of the list of cells of a node.
  int numPoints(const BlockShape& shape) const {
    return shape.level == 0 ? numCells()
                            : static_cast<int>(clusters_[static_cast<std::size_t>(shape.level - 1)].x.size());
  }

  /// The cells of a node: at each of the block's rotations, session cell c lies in
  /// [c, c + shape.spread()] of the cell c that stands for it. They are given in steps of shape.grain(). On level 0
  /// they are rotate(session, angle). The level is at most top_level.
  WeightedCells cells(const BlockShape& shape, int first_rotation) const;

 private:
  SessionCells session_;
  std::vector<SessionClusters> clusters_;  // of the levels from 1 on
  double first_angle_;
  double step_;
  int count_;
};

}  // namespace map_matcher::search
