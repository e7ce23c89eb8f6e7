#include "map_matcher/simulation/way_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace map_matcher::simulation {
namespace {

constexpr int kNearestCells = 2;  // [cells] how far a point's nearest cell with a way may be

/// A step leads to a cell of the nine around and including one: 0 to 2 down, 3 to 5 along the row, 6 to 8 up. A byte a
/// cell instead of an index keeps the ways of a whole crowd in the processor's cache.
constexpr std::uint8_t kStay = 4;
constexpr std::uint8_t kNoStep = 255;

grid::Cell after(const grid::Cell& cell, std::uint8_t step) { return {cell.x + step % 3 - 1, cell.y + step / 3 - 1}; }

}  // namespace

WayField::WayField(const grid::GridGeometry& geometry, const std::vector<std::uint32_t>& next)
    : geometry_(geometry),
      map_from_grid_(geometry.T_map_grid.rotation()),
      T_grid_map_(geometry.T_map_grid.inverse()),
      grid_from_map_(T_grid_map_.rotation()),
      steps_(next.size(), kNoStep) {
  const auto width = static_cast<std::size_t>(geometry.width);
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (next[i] != kNone) {
      const auto dx = static_cast<int>(next[i] % width) - static_cast<int>(i % width);
      const auto dy = static_cast<int>(next[i] / width) - static_cast<int>(i / width);
      steps_[i] = static_cast<std::uint8_t>(kStay + 3 * dy + dx);
    }
  }
}

std::vector<Eigen::Vector2d> WayField::ahead(const Eigen::Vector2d& p_map, double length) const {
  std::vector<Eigen::Vector2d> way;
  way.reserve(static_cast<std::size_t>(std::max(0.0, length / geometry_.resolution)) + 2);
  std::optional<grid::Cell> cell = cellNear(p_map);
  while (cell) {
    way.push_back(centreOf(*cell));
    length -= way.size() > 1 ? (way.back() - way[way.size() - 2]).norm() : 0.0;
    const std::uint8_t step = steps_[indexOf(*cell)];
    cell = step != kStay && length > 0.0 ? std::optional(after(*cell, step)) : std::nullopt;
  }
  return way;
}

std::optional<grid::Cell> WayField::cellNear(const Eigen::Vector2d& p_map) const {
  const auto leads_on = [&](const grid::Cell& cell) {
    return geometry_.contains(cell) && steps_[indexOf(cell)] != kNoStep;
  };
  const Eigen::Vector2d p_grid = (grid_from_map_ * p_map + T_grid_map_.translation()) / geometry_.resolution;
  const grid::Cell own{static_cast<int>(std::floor(p_grid.x())), static_cast<int>(std::floor(p_grid.y()))};
  if (leads_on(own)) {
    return own;  // no other cell's centre is nearer
  }
  std::optional<grid::Cell> nearest;
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (int y = own.y - kNearestCells; y <= own.y + kNearestCells; ++y) {
    for (int x = own.x - kNearestCells; x <= own.x + kNearestCells; ++x) {
      const double distance = (centreOf({x, y}) - p_map).squaredNorm();
      if (leads_on({x, y}) && distance < nearest_distance) {
        nearest = grid::Cell{x, y};
        nearest_distance = distance;
      }
    }
  }
  return nearest;
}

std::size_t WayField::indexOf(const grid::Cell& cell) const {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(geometry_.width) +
         static_cast<std::size_t>(cell.x);
}

Eigen::Vector2d WayField::centreOf(const grid::Cell& cell) const {
  const Eigen::Vector2d p_grid((cell.x + 0.5) * geometry_.resolution, (cell.y + 0.5) * geometry_.resolution);
  return map_from_grid_ * p_grid + geometry_.T_map_grid.translation();
}

}  // namespace map_matcher::simulation
