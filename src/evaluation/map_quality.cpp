#include "map_matcher/evaluation/map_quality.hpp"

#include "map_matcher/grid/near_walls.hpp"
#include "map_matcher/grid/occupied_cells.hpp"

namespace map_matcher::evaluation {

MapQuality mapQuality(const grid::OccupancyGrid& true_map, const grid::OccupancyGrid& session,
                      const grid::Rigid2& T_true_session, double tolerance, std::int8_t occupied_threshold) {
  const grid::NearWalls near_walls(true_map, tolerance, occupied_threshold);
  MapQuality quality;
  for (const grid::Cell& cell : grid::occupiedCells(session, occupied_threshold)) {
    const Eigen::Vector2d place = T_true_session * session.geometry().cellCentre(cell);
    const grid::Cell there = true_map.geometry().cellAt(place);
    ++quality.occupied;
    if (near_walls.isNearWall(place)) {
      ++quality.on_walls;
    } else if (true_map.geometry().contains(there) && true_map.at(there.x, there.y) != grid::kUnknown) {
      ++quality.falsely_occupied;
    } else {
      ++quality.unknown;
    }
  }
  return quality;
}

}  // namespace map_matcher::evaluation
