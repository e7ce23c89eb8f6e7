#include "map_matcher/grid/grid_geometry.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace map_matcher {

Eigen::Vector2d GridGeometry::cellCentre(const Cell& cell) const {
  return T_map_grid * Eigen::Vector2d((cell.x + 0.5) * resolution, (cell.y + 0.5) * resolution);
}

Cell GridGeometry::cellAt(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d p_grid = T_map_grid.inverse() * p_map / resolution;
  return {static_cast<int>(std::floor(p_grid.x())), static_cast<int>(std::floor(p_grid.y()))};
}

void GridGeometry::validate() const {
  if (!std::isfinite(resolution) || resolution <= 0.0) {
    throw std::invalid_argument("resolution is " + std::to_string(resolution) +
                                ", expected a positive number of metres per cell");
  }
  if (width < 1 || height < 1) {
    throw std::invalid_argument("the grid is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, expected at least 1 x 1");
  }
  if (!std::isfinite(T_map_grid.x) || !std::isfinite(T_map_grid.y) || !std::isfinite(T_map_grid.yaw)) {
    throw std::invalid_argument("origin is (" + std::to_string(T_map_grid.x) + ", " + std::to_string(T_map_grid.y) +
                                ", " + std::to_string(T_map_grid.yaw) + "), expected three finite numbers");
  }
}

}  // namespace map_matcher
