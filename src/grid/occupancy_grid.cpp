#include "map_matcher/grid/occupancy_grid.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace map_matcher::grid {
namespace {

std::size_t numCells(const GridGeometry& geometry) {
  geometry.validate();
  return static_cast<std::size_t>(geometry.width) * static_cast<std::size_t>(geometry.height);
}

}  // namespace

OccupancyGrid::OccupancyGrid(const GridGeometry& geometry)
    : geometry_(geometry), values_(numCells(geometry), kUnknown) {}

OccupancyGrid::OccupancyGrid(const GridGeometry& geometry, std::vector<std::int8_t> values)
    : geometry_(geometry), values_(std::move(values)) {
  const std::size_t expected = numCells(geometry_);
  if (values_.size() != expected) {
    throw std::invalid_argument("the grid has " + std::to_string(values_.size()) +
                                " values, expected width x height = " + std::to_string(geometry_.width) + " x " +
                                std::to_string(geometry_.height) + " = " + std::to_string(expected));
  }
  const auto bad = std::find_if(values_.begin(), values_.end(), [](std::int8_t v) { return v < -1 || v > 100; });
  if (bad != values_.end()) {
    throw std::invalid_argument("value " + std::to_string(static_cast<int>(*bad)) + " at index " +
                                std::to_string(bad - values_.begin()) + ", expected -1 (unknown) or 0 to 100");
  }
}

}  // namespace map_matcher::grid
