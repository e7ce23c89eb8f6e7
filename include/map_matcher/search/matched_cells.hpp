/// \file
/// Which cells of a session map lie on walls of the reference map: what figure 8 of the report shows in red.
#pragma once

#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::search {

/// Occupied session cells by whether their centres fall on occupied reference cells; centres in the session map frame.
struct MatchedCells {
  std::vector<Eigen::Vector2d> matched;    ///< [m], session map frame.
  std::vector<Eigen::Vector2d> unmatched;  ///< [m], session map frame.
};

/// Splits the occupied cells (>= `occupied_threshold` percent) of `session` placed at `T_reference_session`.
MatchedCells splitByMatch(const grid::OccupancyGrid& reference, const grid::OccupancyGrid& session,
                          const grid::Rigid2& T_reference_session,
                          std::int8_t occupied_threshold = grid::kDefaultOccupiedThreshold);

}  // namespace map_matcher::search
