#include "map_matcher/search/matched_cells.hpp"

#include <cstdint>
#include <optional>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/grid/resample.hpp"

namespace map_matcher::search {
namespace {

/// Resolutions that differ by less than this share are the same.
constexpr double kSameResolution = 1e-6;

}  // namespace

MatchedCells splitByMatch(const grid::OccupancyGrid& reference, const grid::OccupancyGrid& session,
                          const grid::Rigid2& T_reference_session, const SearchOptions& options) {
  // The search looks at the reference map in the cells of a coarser session map.
  std::optional<grid::OccupancyGrid> pooled;
  if (session.resolution() > reference.resolution() * (1.0 + kSameResolution)) {
    pooled = grid::resample(reference, session.resolution());
  }
  const grid::OccupancyGrid& walls = pooled ? *pooled : reference;
  const auto threshold = static_cast<std::int8_t>(options.occupied_threshold);
  grid::GridGeometry searched = walls.geometry();
  searched.T_map_grid = cornerOf(reference.geometry(), options.reference_map_cell_offset);
  grid::GridGeometry drawn = session.geometry();
  drawn.T_map_grid = cornerOf(session.geometry(), options.session_map_cell_offset);
  MatchedCells cells;
  for (const grid::Cell& cell : grid::occupiedCells(session, threshold)) {
    const Eigen::Vector2d p_session = drawn.cellCentre(cell);
    const grid::Cell target = searched.cellAt(T_reference_session * p_session);
    const bool hit = searched.contains(target) && walls.at(target.x, target.y) >= threshold;
    (hit ? cells.matched : cells.unmatched).push_back(p_session);
  }
  return cells;
}

}  // namespace map_matcher::search
