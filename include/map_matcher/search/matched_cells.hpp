/// \file
/// Which cells of a session map lie on walls of the reference map: what figure 8 of the report shows in red.
#pragma once

#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/search_options.hpp"

namespace map_matcher::search {

/// Occupied session cells by whether their centres fall on occupied reference cells, as the search counts them
/// (SearchResult::matched_cells, but for what hits_sample_threshold leaves out). Centres with session_map_cell_offset.
struct MatchedCells {
  std::vector<Eigen::Vector2d> matched;    ///< [m], session map frame.
  std::vector<Eigen::Vector2d> unmatched;  ///< [m], session map frame.
};

/// Splits the occupied cells of `session` placed at `T_reference_session`. Of `options` occupied_threshold and the two
/// cell offsets count.
MatchedCells splitByMatch(const grid::OccupancyGrid& reference, const grid::OccupancyGrid& session,
                          const grid::Rigid2& T_reference_session, const SearchOptions& options = {});

}  // namespace map_matcher::search
