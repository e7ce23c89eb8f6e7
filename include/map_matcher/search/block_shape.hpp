/// \file
/// What a node of the exact search stands for, level by level.
#pragma once

namespace map_matcher {

/// A node of a level stands for 2^level rotations, beginning with a multiple of 2^level, and for 2^level x 2^level
/// translations. Its session cells are rotated by the block's middle angle and put together in squares, so that one of
/// them may lie, at any pose of the node, anywhere in a window of the reference map; a wall in the window is a match as
/// far as the upper bound goes. On level 0 a node is a pose, and the window one cell.
struct BlockShape {
  int level = 0;

  static constexpr int kMaxLevel = 6;

  /// Rotations, and translations along an axis [cells].
  constexpr int stride() const { return 1 << level; }

  /// Half the arc that the farthest session cell describes within the block [cells]: a rotation step of eq. 4.2 with
  /// rotation_downsampling 1 moves it at most half a cell.
  constexpr double halfArc() const { return (stride() - 1) / 4.0; }

  /// Cells by which flooring can tell the ends of the arc apart: ceil(2 halfArc()).
  constexpr int arc() const { return stride() / 2; }

  /// Edge of the squares in which session cells are put together [cells]. Larger ones are fewer, but widen the window.
  constexpr int merged() const { return level < 3 ? 1 : stride() / 4; }

  /// Edge of the window [cells]. A session cell at c stands for cells in [c, c + window() - stride()], and a
  /// translation moves them by up to stride() - 1 more.
  constexpr int window() const { return stride() + arc() + merged() - 1; }
};

}  // namespace map_matcher
