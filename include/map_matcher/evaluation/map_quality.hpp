/// \file
/// What a session map is worth against the true map: the false occupancy of the report's figure 5.
#pragma once

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::evaluation {

/// Occupied cells of a session map by what is really there.
struct MapQuality {
  int occupied = 0;          ///< All of them [cells].
  int on_walls = 0;          ///< Within the tolerance of a true wall [cells].
  int falsely_occupied = 0;  ///< In free space [cells].
  int unknown = 0;           ///< Where the true map is unknown, or outside it [cells].
};

/// Compares the occupied cells (>= `occupied_threshold` percent) of `session`, placed at `T_true_session`, with the
/// true map. `tolerance` [m], at least 0, for the noise of the laser and of the pose.
MapQuality mapQuality(const grid::OccupancyGrid& true_map, const grid::OccupancyGrid& session,
                      const grid::Rigid2& T_true_session, double tolerance,
                      std::int8_t occupied_threshold = grid::kDefaultOccupiedThreshold);

}  // namespace map_matcher::evaluation
