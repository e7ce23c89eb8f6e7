/// \file
/// Random maps and buildings for property tests, and the slow, obvious answers they are held against.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "map_matcher/grid/grid_geometry.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/counting/precomputed_grids.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/counting/search_window.hpp"
#include "map_matcher/search/two_stage/branch_and_bound.hpp"

namespace map_matcher::test {

/// A whole number in [low, high], the same for a seed on every standard library.
inline int randomInt(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint32_t>(high - low + 1));
}

/// A number in [low, high), the same for a seed on every standard library.
inline double randomReal(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

inline std::vector<grid::Cell> randomCells(std::mt19937& random, int width, int height, int count) {
  std::vector<grid::Cell> cells;
  for (int k = 0; k < count; ++k) {
    cells.push_back({randomInt(random, 0, width - 1), randomInt(random, 0, height - 1)});
  }
  return cells;
}

/// Rotated cells around the origin, in [-reach, reach].
inline search::RotatedCells randomRotatedCells(std::mt19937& random, int reach, int count) {
  search::RotatedCells cells;
  for (int k = 0; k < count; ++k) {
    cells.x.push_back(static_cast<std::int16_t>(randomInt(random, -reach, reach)));
    cells.y.push_back(static_cast<std::int16_t>(randomInt(random, -reach, reach)));
  }
  return cells;
}

/// Whether a wall lies in [x, x + size) x [y, y + size), by looking at every wall.
inline bool wallWithin(const std::vector<grid::Cell>& walls, int x, int y, int size) {
  for (const grid::Cell& wall : walls) {
    if (wall.x >= x && wall.x < x + size && wall.y >= y && wall.y < y + size) {
      return true;
    }
  }
  return false;
}

/// Cells that, moved by a translation, have value 1 in a level: one by one.
inline std::int32_t countMatches(const search::PooledLevel& level, const search::RotatedCells& cells,
                                 const grid::Cell& translation) {
  std::int32_t count = 0;
  for (std::size_t k = 0; k < cells.x.size(); ++k) {
    count += level.at(cells.x[k] + translation.x, cells.y[k] + translation.y);
  }
  return count;
}

/// The first, by rotation, y and x, of the poses of the windows with the most matches, by trying all of them.
inline search::SearchPose firstOfTheBest(const search::PrecomputedGrids& reference,
                                         const std::vector<search::RotatedCells>& rotations,
                                         const std::vector<search::SearchWindow>& windows) {
  search::SearchPose best;
  for (std::size_t n = 0; n < rotations.size(); ++n) {
    for (int y = windows[n].first.y; y <= windows[n].last.y; ++y) {
      for (int x = windows[n].first.x; x <= windows[n].last.x; ++x) {
        const std::int32_t count = countMatches(reference.level(0), rotations[n], {x, y});
        if (count > best.count) {
          best = {static_cast<int>(n), {x, y}, count};
        }
      }
    }
  }
  return best;
}

/// The most matches of any rotation and translation of the windows, by trying all of them.
inline std::int32_t exhaustiveBest(const search::PrecomputedGrids& reference,
                                   const std::vector<search::RotatedCells>& rotations,
                                   const std::vector<search::SearchWindow>& windows) {
  return firstOfTheBest(reference, rotations, windows).count;
}

/// Walls of a building whose rooms are of random sizes: no two places of it look alike.
inline grid::OccupancyGrid randomBuilding(std::mt19937& random, double width, double height, double resolution,
                                          const grid::Rigid2& T_map_grid = {}) {
  grid::GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = static_cast<int>(std::lround(width / resolution));
  geometry.height = static_cast<int>(std::lround(height / resolution));
  geometry.T_map_grid = T_map_grid;
  grid::OccupancyGrid grid(
      geometry, std::vector<std::int8_t>(
                    static_cast<std::size_t>(geometry.width) * static_cast<std::size_t>(geometry.height), grid::kFree));
  const auto wall = [&grid, resolution](double x, double y, double length, bool along_x) {
    const int n = static_cast<int>(std::lround(length / resolution));
    for (int k = 0; k < n; ++k) {
      const grid::Cell cell{static_cast<int>(x / resolution) + (along_x ? k : 0),
                            static_cast<int>(y / resolution) + (along_x ? 0 : k)};
      if (grid.geometry().contains(cell)) {
        grid.at(cell.x, cell.y) = grid::kOccupied;
      }
    }
  };
  wall(0.0, 0.0, width, true);
  wall(0.0, height - resolution, width, true);
  wall(0.0, 0.0, height, false);
  wall(width - resolution, 0.0, height, false);
  const int num_walls = static_cast<int>(width * height / 6.0);
  for (int k = 0; k < num_walls; ++k) {
    wall(randomReal(random, 0.0, width), randomReal(random, 0.0, height), randomReal(random, 0.3, 4.0),
         random() % 2 == 0);
  }
  return grid;
}

/// What a perfect session of the square of `size` around `centre` looks like in a session map whose frame lies at
/// T_reference_session: each wall cell of the reference within the square, drawn into the session cell that holds it.
/// The session grid is `T_session_grid` and as large as it must be.
inline grid::OccupancyGrid cutSession(const grid::OccupancyGrid& reference, const Eigen::Vector2d& centre, double size,
                                      const grid::Rigid2& T_reference_session, double resolution) {
  const grid::Rigid2 T_session_reference = T_reference_session.inverse();
  const double reach = size;  // holds the square at every angle
  const Eigen::Vector2d middle = T_session_reference * centre;
  grid::GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = geometry.height = static_cast<int>(std::ceil(2.0 * reach / resolution));
  geometry.T_map_grid = {middle.x() - reach, middle.y() - reach, 0.0};
  grid::OccupancyGrid session(geometry);
  const grid::Rigid2 T_reference_map = T_reference_session;
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const Eigen::Vector2d p = T_reference_map * geometry.cellCentre({x, y});
      const grid::Cell cell = reference.geometry().cellAt(p);
      const bool inside = (p - centre).cwiseAbs().maxCoeff() <= 0.5 * size && reference.geometry().contains(cell);
      if (inside) {
        session.at(x, y) = reference.at(cell.x, cell.y);
      }
    }
  }
  return session;
}

}  // namespace map_matcher::test
