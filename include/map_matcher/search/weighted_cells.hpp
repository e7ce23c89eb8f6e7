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
  /// it. Each weight keeps the order of the cells.
  WeightedCells merge(const RotatedCells& cells, int block);

 private:
  struct Slot {
    std::uint32_t key = 0;
    std::uint32_t generation = 0;  // of the call that filled it; others are empty
    std::uint32_t index = 0;       // into merged_ and weights_
  };

  void clearTable(std::size_t num_cells);
  void add(std::int16_t x, std::int16_t y);
  WeightedCells sortedByWeight(std::int32_t total) const;

  std::vector<Slot> table_;  // open addressing; its size is a power of two
  int shift_ = 0;            // leaves the bits of a hash that are an index into table_
  std::uint32_t generation_ = 0;
  RotatedCells merged_;
  std::vector<std::int32_t> weights_;
};

}  // namespace map_matcher
