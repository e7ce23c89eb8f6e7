#include "map_matcher/search/matched_cells.hpp"

#include "map_matcher/grid/occupied_cells.hpp"

namespace map_matcher::search {

MatchedCells splitByMatch(const grid::OccupancyGrid& reference, const grid::OccupancyGrid& session,
                          const grid::Rigid2& T_reference_session, std::int8_t occupied_threshold) {
  MatchedCells cells;
  for (const grid::Cell& cell : grid::occupiedCells(session, occupied_threshold)) {
    const Eigen::Vector2d p_session = session.geometry().cellCentre(cell);
    const grid::Cell target = reference.geometry().cellAt(T_reference_session * p_session);
    const bool hit = reference.geometry().contains(target) && reference.at(target.x, target.y) >= occupied_threshold;
    (hit ? cells.matched : cells.unmatched).push_back(p_session);
  }
  return cells;
}

}  // namespace map_matcher::search
