#include "map_matcher/search/search_session.hpp"

#include <cstdint>
#include <utility>

#include "map_matcher/grid/occupied_cells.hpp"

namespace map_matcher::search {

SearchSession searchSession(const grid::OccupancyGrid& session, double resolution, const SearchOptions& options) {
  const double offset = -options.session_map_cell_offset * session.resolution();
  SearchSession result;
  result.cells = grid::occupiedCells(session, static_cast<std::int8_t>(options.occupied_threshold));
  result.resolution = session.resolution();
  result.T_session_grid = session.geometry().T_map_grid * grid::Rigid2{offset, offset, 0.0};
  if (!result.cells.empty()) {
    result.fine = prepareSessionCells(result.cells, session.resolution(), resolution, CellMerging::kNone,
                                      options.hits_sample_threshold);
  }
  return result;
}

}  // namespace map_matcher::search
