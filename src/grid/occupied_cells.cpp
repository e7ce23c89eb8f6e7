#include "map_matcher/grid/occupied_cells.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace map_matcher::grid {
namespace {

/// Cells that are looked at together: most of a map is no wall.
constexpr int kBlock = 64;

/// Without an early end, so that compilers turn it into vector instructions.
bool anyReaches(const std::int8_t* begin, const std::int8_t* end, std::int8_t threshold) {
  std::int8_t largest = *begin;
  for (const std::int8_t* value = begin; value != end; ++value) {
    largest = *value > largest ? *value : largest;
  }
  return largest >= threshold;
}

}  // namespace

std::vector<Cell> occupiedCells(const OccupancyGrid& grid, std::int8_t occupied_threshold) {
  if (occupied_threshold < 1 || occupied_threshold > 100) {
    throw std::invalid_argument("occupied_threshold is " + std::to_string(static_cast<int>(occupied_threshold)) +
                                ", expected 1 to 100 percent");
  }
  std::vector<Cell> cells;
  for (int y = 0; y < grid.height(); ++y) {
    const std::int8_t* row = grid.values().data() + static_cast<std::ptrdiff_t>(y) * grid.width();
    for (int x = 0; x < grid.width(); x += kBlock) {
      const int end = std::min(x + kBlock, grid.width());
      if (!anyReaches(row + x, row + end, occupied_threshold)) {
        continue;
      }
      for (int k = x; k < end; ++k) {
        if (row[k] >= occupied_threshold) {
          cells.push_back({k, y});
        }
      }
    }
  }
  return cells;
}

}  // namespace map_matcher::grid
