#include "map_matcher/grid/grid_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::grid {
namespace {

/// The conversion of a number that an int cannot hold has no defined result.
int toCell(double coordinate) {
  constexpr double kFarthest = kFarthestCell;
  return coordinate > -kFarthest ? static_cast<int>(std::floor(std::min(coordinate, kFarthest))) : -kFarthestCell;
}

}  // namespace

Cell cellOf(const Eigen::Vector2d& point, double resolution) {
  return {toCell(point.x() / resolution), toCell(point.y() / resolution)};
}

Eigen::Vector2d GridGeometry::cellCentre(const Cell& cell) const {
  return T_map_grid * Eigen::Vector2d((cell.x + 0.5) * resolution, (cell.y + 0.5) * resolution);
}

Cell GridGeometry::cellAt(const Eigen::Vector2d& p_map) const {
  return cellOf(T_map_grid.inverse() * p_map, resolution);
}

void GridGeometry::validate() const {
  if (!std::isfinite(resolution) || resolution <= 0.0) {
    throw std::invalid_argument("resolution is " + parameters::numberText(resolution) +
                                ", expected a positive number of metres per cell");
  }
  if (width < 1 || height < 1) {
    throw std::invalid_argument("the grid is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, expected at least 1 x 1");
  }
  constexpr std::int64_t kMostCells = std::numeric_limits<std::int32_t>::max();
  if (std::int64_t{width} * height > kMostCells) {
    throw std::invalid_argument("the grid is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, expected at most " + std::to_string(kMostCells) + " in all");
  }
  if (!std::isfinite(T_map_grid.x) || !std::isfinite(T_map_grid.y) || !std::isfinite(T_map_grid.yaw)) {
    throw std::invalid_argument("origin is (" + parameters::numberText(T_map_grid.x) + ", " +
                                parameters::numberText(T_map_grid.y) + ", " + parameters::numberText(T_map_grid.yaw) +
                                "), expected three finite numbers");
  }
}

Rigid2 cornerOf(const GridGeometry& geometry, double cell_offset) {
  const double offset = -cell_offset * geometry.resolution;
  return geometry.T_map_grid * Rigid2{offset, offset, 0.0};
}

}  // namespace map_matcher::grid
