/// \file
/// What the searches look at of a session map.
#pragma once

#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/search/counting/session_cells.hpp"
#include "map_matcher/search/search_options.hpp"

namespace map_matcher::search {

/// A session map's walls.
struct SearchSession {
  std::vector<grid::Cell> cells;  ///< The occupied ones.
  double resolution = 0.05;       ///< Edge length of a cell [m].
  SessionCells fine;  ///< At the resolution of the fine stage and the exact search; without points if there is
                      ///< no occupied cell.
  grid::Rigid2 T_session_grid;  ///< Pose of the grid's corner in the session map frame, with session_map_cell_offset.
};

/// `resolution` is that of the fine stage [m].
SearchSession searchSession(const grid::OccupancyGrid& session, double resolution, const SearchOptions& options);

}  // namespace map_matcher::search
