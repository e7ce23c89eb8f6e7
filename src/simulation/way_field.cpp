#include "map_matcher/simulation/way_field.hpp"

#include <cstddef>
#include <utility>

namespace map_matcher {
namespace {

constexpr int kNearestCells = 2;  // [cells] how far a point's nearest cell with a way may be

}  // namespace

WayField::WayField(const GridGeometry& geometry, std::vector<std::uint32_t> next)
    : geometry_(geometry), next_(std::move(next)) {}

std::vector<Eigen::Vector2d> WayField::ahead(const Eigen::Vector2d& p_map, double length) const {
  std::vector<Eigen::Vector2d> way;
  std::optional<std::uint32_t> index = indexNear(p_map);
  while (index) {
    way.push_back(centreOf(*index));
    length -= way.size() > 1 ? (way.back() - way[way.size() - 2]).norm() : 0.0;
    const std::uint32_t next = next_[*index];
    index = next != *index && length > 0.0 ? std::optional(next) : std::nullopt;
  }
  return way;
}

std::optional<std::uint32_t> WayField::indexNear(const Eigen::Vector2d& p_map) const {
  const Cell centre = geometry_.cellAt(p_map);
  std::optional<std::uint32_t> nearest;
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (int y = centre.y - kNearestCells; y <= centre.y + kNearestCells; ++y) {
    for (int x = centre.x - kNearestCells; x <= centre.x + kNearestCells; ++x) {
      const auto index = static_cast<std::uint32_t>(y * geometry_.width + x);
      if (geometry_.contains({x, y}) && next_[index] != kNone) {
        const double distance = (geometry_.cellCentre({x, y}) - p_map).squaredNorm();
        if (distance < nearest_distance) {
          nearest = index;
          nearest_distance = distance;
        }
      }
    }
  }
  return nearest;
}

Eigen::Vector2d WayField::centreOf(std::uint32_t index) const {
  const auto width = static_cast<std::uint32_t>(geometry_.width);
  return geometry_.cellCentre({static_cast<int>(index % width), static_cast<int>(index / width)});
}

}  // namespace map_matcher
