#include "map_matcher/grid/seen_space.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "map_matcher/grid/chamfer_distances.hpp"
#include "map_matcher/grid/occupied_cells.hpp"

namespace map_matcher::grid {
namespace {

/// Sets the cells within `distance` [cells] of a wall. Walls come in the order of rows.
void markNear(const std::vector<Cell>& walls, double distance, const GridGeometry& geometry, std::vector<Seen>& seen) {
  const std::vector<int> half_widths = chamferDisc(distance);
  const int reach = static_cast<int>(half_widths.size()) / 2;
  for (std::size_t begin = 0, end = 0; begin < walls.size(); begin = end) {
    for (end = begin + 1;
         end < walls.size() && walls[end].y == walls[begin].y && walls[end].x == walls[end - 1].x + 1;) {
      ++end;
    }
    for (int dy = -reach; dy <= reach; ++dy) {
      const int y = walls[begin].y + dy;
      const int half_width = half_widths[static_cast<std::size_t>(dy + reach)];
      const int first = std::max(walls[begin].x - half_width, 0);
      const int last = std::min(walls[end - 1].x + half_width, geometry.width - 1);
      if (y >= 0 && y < geometry.height) {
        const auto row = seen.begin() + static_cast<std::ptrdiff_t>(y) * geometry.width;
        std::fill(row + first, row + last + 1, Seen::kNearWall);
      }
    }
  }
}

/// The cells on the middle lines of walls, or `deepest` [cells] below the surface of thicker ones.
std::vector<Cell> middleLines(const std::vector<Cell>& walls, double deepest, const GridGeometry& geometry) {
  const ChamferDepths depths(walls, deepest + 1.0, geometry.width, geometry.height);
  std::vector<Cell> cells;
  for (const Cell& wall : walls) {
    const double here = depths.at(wall);
    const bool is_ridge = here < deepest && here >= depths.deepestAround(wall);
    if (is_ridge || (here >= deepest && here < deepest + 1.0)) {
      cells.push_back(wall);
    }
  }
  return cells;
}

}  // namespace

SeenSpace::SeenSpace(const OccupancyGrid& map, double cell_offset, int occupied_threshold) : geometry_(map.geometry()) {
  geometry_.T_map_grid = cornerOf(map.geometry(), cell_offset);
  const std::vector<Cell> walls = occupiedCells(map, static_cast<std::int8_t>(occupied_threshold));
  seen_.reserve(map.values().size());
  std::transform(map.values().begin(), map.values().end(), std::back_inserter(seen_), [&](std::int8_t value) {
    return value >= 0 && value <= 100 - occupied_threshold ? Seen::kOpen : Seen::kUnseen;
  });
  markNear(walls, kNear / geometry_.resolution, geometry_, seen_);
  for (const Cell& cell : middleLines(walls, std::max(1.0, kNear / geometry_.resolution), geometry_)) {
    walls_.push_back(geometry_.cellCentre(cell));
  }
}

Seen SeenSpace::at(const Eigen::Vector2d& p_map) const {
  const Cell cell = geometry_.cellAt(p_map);
  if (!geometry_.contains(cell)) {
    return Seen::kUnseen;
  }
  return seen_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(geometry_.width) +
               static_cast<std::size_t>(cell.x)];
}

}  // namespace map_matcher::grid
