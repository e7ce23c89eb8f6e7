/// \file
/// Grids drawn as text, so that a test shows the map it is about.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::test {

/// Value of a drawn cell: '#' occupied, '.' free, ' ' or '?' unknown. Throws std::invalid_argument for anything else.
inline std::int8_t valueOf(char drawn) {
  switch (drawn) {
    case '#':
      return grid::kOccupied;
    case '.':
      return grid::kFree;
    case ' ':
    case '?':
      return grid::kUnknown;
    default:
      throw std::invalid_argument(std::string("'") + drawn + "' in a drawn map, expected '#', '.', ' ' or '?'");
  }
}

/// The grid that `rows` draw, the top row first as on a map, so that the last row is y = 0. Rows shorter than the
/// longest end in unknown cells. `resolution` [m]; `T_map_grid` is the pose of the lower left corner.
inline grid::OccupancyGrid asciiMap(const std::vector<std::string>& rows, double resolution = 1.0,
                                    const grid::Rigid2& T_map_grid = {}) {
  grid::GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.height = static_cast<int>(rows.size());
  for (const std::string& row : rows) {
    geometry.width = std::max(geometry.width, static_cast<int>(row.size()));
  }
  geometry.T_map_grid = T_map_grid;

  grid::OccupancyGrid grid(geometry);
  for (int y = 0; y < geometry.height; ++y) {
    const std::string& row = rows[static_cast<std::size_t>(geometry.height - 1 - y)];
    for (int x = 0; x < static_cast<int>(row.size()); ++x) {
      grid.at(x, y) = valueOf(row[static_cast<std::size_t>(x)]);
    }
  }
  return grid;
}

/// The drawing of a grid, the top row first: '#' from 65 percent on, '?' unknown, '.' the rest.
inline std::vector<std::string> drawingOf(const grid::OccupancyGrid& grid) {
  std::vector<std::string> rows;
  for (int y = grid.height() - 1; y >= 0; --y) {
    std::string row;
    for (int x = 0; x < grid.width(); ++x) {
      const std::int8_t value = grid.at(x, y);
      row += value == grid::kUnknown ? '?' : value >= grid::kDefaultOccupiedThreshold ? '#' : '.';
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace map_matcher::test
