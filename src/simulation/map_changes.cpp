#include "map_matcher/simulation/map_changes.hpp"

#include "map_matcher/simulation/rectangle.hpp"

namespace map_matcher::simulation {

grid::OccupancyGrid withoutPart(grid::OccupancyGrid map, const Rectangle& part) {
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (contains(part, map.geometry().cellCentre({x, y}))) {
        map.at(x, y) = grid::kUnknown;
      }
    }
  }
  return map;
}

}  // namespace map_matcher::simulation
