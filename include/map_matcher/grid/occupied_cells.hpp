/// \file
/// The occupied cells of a grid, which are all that a search looks at.
#pragma once

#include <cstdint>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::grid {

/// Cells whose value is at least `occupied_threshold` [percent, 1 to 100], row by row from the lower left. Unknown
/// cells are never among them. Throws std::invalid_argument for a threshold out of range.
std::vector<Cell> occupiedCells(const OccupancyGrid& grid, std::int8_t occupied_threshold = kDefaultOccupiedThreshold);

}  // namespace map_matcher::grid
