/// \file
/// Changing the resolution of a grid without losing a wall.
#pragma once

#include <functional>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::grid {

/// The grid at another resolution [m], same origin, large enough to cover the old one. Each new cell takes the largest
/// value of the old cells it overlaps, so an occupied cell is never lost, a cell is unknown only when all it covers is
/// unknown, and unknown never becomes a wall. (The max operator of report section 3.1, for any ratio of resolutions.)
/// Throws std::invalid_argument when the resolution is not positive and finite. `before_row` is called before each row
/// is made, and may throw to give the work up.
OccupancyGrid resample(const OccupancyGrid& grid, double resolution, const std::function<void()>& before_row = {});

}  // namespace map_matcher::grid
