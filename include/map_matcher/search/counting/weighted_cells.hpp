/// \file
/// Cells of which some count more than once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/search/counting/rotations.hpp"

namespace map_matcher::search {

/// Cells that count several times, in runs of the same weight. One whose weight few others have may stand in the list
/// for each binary digit of it.
struct WeightedCells {
  /// Neighbours in the list of cells that have the same weight.
  struct Run {
    std::size_t size = 0;     ///< [cells]
    std::int32_t weight = 1;  ///< How often each of them counts, at least once.
  };

  RotatedCells cells;      ///< The heaviest first.
  std::vector<Run> runs;   ///< Of all cells, in their order.
  std::int32_t total = 0;  ///< Sum of all weights.
};

}  // namespace map_matcher::search
