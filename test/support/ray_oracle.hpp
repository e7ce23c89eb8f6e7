/// \file
/// The slow and obvious way to meet walls, to compare the fast one with.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::test {

/// Where a ray enters the square of a cell [cells], infinity when it does not; `origin` and `direction` in cells.
inline double entryInto(const grid::Cell& cell, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d corner(cell.x, cell.y);
  double entry = 0.0;
  double exit = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    const double near = (corner[axis] + (direction[axis] > 0.0 ? 0.0 : 1.0) - origin[axis]) / direction[axis];
    const double far = (corner[axis] + (direction[axis] > 0.0 ? 1.0 : 0.0) - origin[axis]) / direction[axis];
    entry = std::max(entry, near);
    exit = std::min(exit, far);
  }
  return entry <= exit ? entry : std::numeric_limits<double>::infinity();
}

/// Distance [m] from a point of the map to the first solid cell on a ray, by looking at every cell of the grid. The ray
/// must not be parallel to the grid's axes.
inline double castRayByEveryCell(const grid::OccupancyGrid& grid, const Eigen::Vector2d& p_map, double heading) {
  const grid::GridGeometry& geometry = grid.geometry();
  const Eigen::Vector2d origin = geometry.T_map_grid.inverse() * p_map / geometry.resolution;
  const double angle = heading - geometry.T_map_grid.yaw;
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  double nearest = std::numeric_limits<double>::infinity();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.at(x, y) >= grid::kDefaultOccupiedThreshold) {
        nearest = std::min(nearest, entryInto({x, y}, origin, direction));
      }
    }
  }
  return nearest * geometry.resolution;
}

/// Distance [m] from a point of the map to the nearest square that is occupied or unknown, or to the grid's edge, by
/// looking at every cell; 0 in such a place.
inline double clearanceByEveryCell(const grid::OccupancyGrid& grid, const Eigen::Vector2d& p_map) {
  const grid::GridGeometry& geometry = grid.geometry();
  const Eigen::Vector2d p = geometry.T_map_grid.inverse() * p_map / geometry.resolution;
  double nearest = std::min({p.x(), p.y(), grid.width() - p.x(), grid.height() - p.y()});
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const std::int8_t value = grid.at(x, y);
      if (value == grid::kUnknown || value >= grid::kDefaultOccupiedThreshold) {
        const double dx = std::max({x - p.x(), 0.0, p.x() - (x + 1)});
        const double dy = std::max({y - p.y(), 0.0, p.y() - (y + 1)});
        nearest = std::min(nearest, std::hypot(dx, dy));
      }
    }
  }
  return std::max(0.0, nearest) * geometry.resolution;
}

}  // namespace map_matcher::test
