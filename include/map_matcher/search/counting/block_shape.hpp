/// \file
/// What a node of the exact search stands for, level by level.
#pragma once

namespace map_matcher::search {

/// A node of a level stands for 2^level rotations, beginning with a multiple of 2^level, and for 2^level x 2^level
/// translations. Its session cells are put together in clusters and rotated by the block's middle angle, so that one of
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

  /// Room for a cluster on the arc [cells]: the arc's both ends, rounded up, and on high levels some more. Larger
  /// clusters are fewer, but widen the window.
  constexpr int room() const { return level == 0 ? 0 : stride() / 2 + (level < 3 ? 0 : stride() / 8 - 1); }

  /// Positions of nodes, of the cells that stand for others and hence of windows are multiples of this [cells]: a high
  /// level needs no more, and a small part of the memory.
  constexpr int grain() const { return 1 << grainLevel(); }
  constexpr int grainLevel() const { return level < 3 ? 0 : level - 2; }  ///< Logarithm of the grain.

  /// How far a session cell may lie right of and above the cell that stands for it, at most [cells].
  constexpr int spread() const { return room() + grain() - 1; }

  /// Edge of the window [cells]: a translation moves a cell by up to stride() - 1 more.
  constexpr int window() const { return stride() + spread(); }
};

}  // namespace map_matcher::search
