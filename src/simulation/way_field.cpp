#include "map_matcher/simulation/way_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace map_matcher {
namespace {

constexpr int kNearestCells = 2;  // [cells] how far a point's nearest cell with a way may be

}  // namespace

WayField::WayField(const GridGeometry& geometry, std::vector<std::uint32_t> next)
    : geometry_(geometry),
      map_from_grid_(geometry.T_map_grid.rotation()),
      T_grid_map_(geometry.T_map_grid.inverse()),
      grid_from_map_(T_grid_map_.rotation()),
      next_(std::move(next)) {}

std::vector<Eigen::Vector2d> WayField::ahead(const Eigen::Vector2d& p_map, double length) const {
  std::vector<Eigen::Vector2d> way;
  way.reserve(static_cast<std::size_t>(std::max(0.0, length / geometry_.resolution)) + 2);
  const auto width = static_cast<std::uint32_t>(geometry_.width);
  std::optional<std::uint32_t> index = indexNear(p_map);
  while (index) {
    way.push_back(centreOf({static_cast<int>(*index % width), static_cast<int>(*index / width)}));
    length -= way.size() > 1 ? (way.back() - way[way.size() - 2]).norm() : 0.0;
    const std::uint32_t next = next_[*index];
    index = next != *index && length > 0.0 ? std::optional(next) : std::nullopt;
  }
  return way;
}

std::optional<std::uint32_t> WayField::indexNear(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d p_grid = (grid_from_map_ * p_map + T_grid_map_.translation()) / geometry_.resolution;
  const Cell centre{static_cast<int>(std::floor(p_grid.x())), static_cast<int>(std::floor(p_grid.y()))};
  const auto own = static_cast<std::uint32_t>(centre.y * geometry_.width + centre.x);
  if (geometry_.contains(centre) && next_[own] != kNone) {
    return own;  // no other cell's centre is nearer
  }
  std::optional<std::uint32_t> nearest;
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (int y = centre.y - kNearestCells; y <= centre.y + kNearestCells; ++y) {
    for (int x = centre.x - kNearestCells; x <= centre.x + kNearestCells; ++x) {
      const auto index = static_cast<std::uint32_t>(y * geometry_.width + x);
      if (geometry_.contains({x, y}) && next_[index] != kNone) {
        const double distance = (centreOf({x, y}) - p_map).squaredNorm();
        if (distance < nearest_distance) {
          nearest = index;
          nearest_distance = distance;
        }
      }
    }
  }
  return nearest;
}

Eigen::Vector2d WayField::centreOf(const Cell& cell) const {
  const Eigen::Vector2d p_grid((cell.x + 0.5) * geometry_.resolution, (cell.y + 0.5) * geometry_.resolution);
  return map_from_grid_ * p_grid + geometry_.T_map_grid.translation();
}

}  // namespace map_matcher
