/// \file
/// Session cells put together for the high levels of the exact search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/search/rotations.hpp"

namespace map_matcher {

/// Cells of which some count more than once.
struct WeightedCells {
  /// Neighbours in the list of cells that have the same weight.
  struct Run {
    std::size_t size = 0;     ///< [cells]
    std::int32_t weight = 1;  ///< How often each of them counts.
  };

  RotatedCells cells;      ///< The heaviest first.
  std::vector<Run> runs;   ///< Of all cells, in their order.
  std::int32_t total = 0;  ///< Sum of all weights.
};

/// Puts cells together that fall into the same block. Keeps its memory between calls; one for each thread.
class CellMerger {
 public:
  /// One cell for each block of `block` x `block` cells (a power of two) that holds any: the lower left cell of the
  /// block, weighted by how many there are. So a cell lies up to block - 1 right of and above the one that stands for
  /// it. Each weight keeps the order of the cells. Cells so far apart that a table of all blocks would take more than
  /// 64 MiB stay as they are.
  WeightedCells merge(const RotatedCells& cells, int block);

 private:
  /// Lower left and upper right corner of the blocks of some cells [blocks].
  struct Box {
    int first_x;
    int first_y;
    int width;
    int height;
  };

  static Box boxOf(const RotatedCells& cells, int shift);
  void countBlocks(const RotatedCells& cells, const Box& box, int shift);
  WeightedCells sortedByWeight(const Box& box, int shift);

  std::vector<std::int32_t> weights_;  // of the blocks of the box, row by row; zeros between calls
  std::vector<std::uint32_t> filled_;  // indices of the blocks that hold a cell, by their first one
};

}  // namespace map_matcher
