#include "map_matcher/grid/occupied_cells.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace map_matcher {

std::vector<Cell> occupiedCells(const OccupancyGrid& grid, std::int8_t occupied_threshold) {
  if (occupied_threshold < 1 || occupied_threshold > 100) {
    throw std::invalid_argument("occupied_threshold is " + std::to_string(static_cast<int>(occupied_threshold)) +
                                ", expected 1 to 100 percent");
  }
  const auto is_wall = [occupied_threshold](std::int8_t value) { return value >= occupied_threshold; };
  std::vector<Cell> cells;
  for (int y = 0; y < grid.height(); ++y) {
    const auto row = grid.values().begin() + static_cast<std::ptrdiff_t>(y) * grid.width();
    const auto end = row + grid.width();
    for (auto it = std::find_if(row, end, is_wall); it != end; it = std::find_if(it + 1, end, is_wall)) {
      cells.push_back({static_cast<int>(it - row), y});
    }
  }
  return cells;
}

}  // namespace map_matcher
