/// \file
/// Where the walls of a map are.
#pragma once

#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::test {

/// Occupied cells of a map, as their centres [m].
inline std::vector<Eigen::Vector2d> wallsOf(const grid::OccupancyGrid& map) {
  std::vector<Eigen::Vector2d> centres;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (map.at(x, y) == grid::kOccupied) {
        centres.push_back(map.geometry().cellCentre({x, y}));
      }
    }
  }
  return centres;
}

}  // namespace map_matcher::test
