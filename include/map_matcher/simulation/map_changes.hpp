/// \file
/// Maps that differ from the building that is driven in.
#pragma once

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/simulation/rectangle.hpp"

namespace map_matcher::simulation {

/// The map of somebody who has never been in a part of the building: every cell whose centre lies in `part` [m, map
/// frame] is unknown.
grid::OccupancyGrid withoutPart(grid::OccupancyGrid map, const Rectangle& part);

}  // namespace map_matcher::simulation
