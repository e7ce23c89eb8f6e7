/// \file
/// The session cells under all rotations of the exact search, and under blocks of them.
#pragma once

#include <vector>

#include "map_matcher/search/block_shape.hpp"
#include "map_matcher/search/session_cells.hpp"
#include "map_matcher/search/weighted_cells.hpp"

namespace map_matcher {

/// A row of rotations of a session, `step` apart. Immutable, hence thread-safe.
class RotationBlocks {
 public:
  /// Rotations first_angle + n * step, n = 0 ... count - 1 [rad]. The step moves no cell by more than half a cell, as
  /// that of eq. 4.2 with rotation_downsampling 1 does; else std::invalid_argument is thrown.
  RotationBlocks(const SessionCells& session, double first_angle, double step, int count);

  int count() const { return count_; }                                          ///< Number of rotations.
  double angle(int rotation) const { return first_angle_ + rotation * step_; }  ///< [rad]
  double step() const { return step_; }                                         ///< [rad]
  int numCells() const { return static_cast<int>(session_.points.size()); }     ///< [cells]

  /// The cells of a node: at each of the block's rotations, session cell c lies in
  /// [c, c + shape.window() - shape.stride()] of the cell that stands for it. On level 0 they are rotate(session,
  /// angle).
  WeightedCells cells(const BlockShape& shape, int first_rotation, CellMerger& merger) const;

 private:
  RotatedCells lowerCorners(const BlockShape& shape, double middle) const;

  SessionCells session_;
  std::vector<float> x_;  // of the points [cells]
  std::vector<float> y_;
  double first_angle_;
  double step_;
  int count_;
};

}  // namespace map_matcher
