#include "map_matcher/grid/map_limits.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::grid {

void requireMapLimits(const GridGeometry& geometry) {
  geometry.validate();
  if (geometry.resolution < kMinMapResolution || geometry.resolution > kMaxMapResolution) {
    throw std::invalid_argument("resolution is " + parameters::numberText(geometry.resolution) +
                                ", expected a positive number of metres per cell, " +
                                parameters::numberText(kMinMapResolution) + " to " +
                                parameters::numberText(kMaxMapResolution));
  }
  const Rigid2& origin = geometry.T_map_grid;
  if (std::abs(origin.x) > kMaxMapOrigin || std::abs(origin.y) > kMaxMapOrigin) {
    throw std::invalid_argument("origin is (" + parameters::numberText(origin.x) + ", " +
                                parameters::numberText(origin.y) + ", " + parameters::numberText(origin.yaw) +
                                "), expected x and y within " + parameters::numberText(kMaxMapOrigin) + " m");
  }
  if (std::int64_t{geometry.width} * geometry.height > kMostMapCells) {
    throw std::invalid_argument("the map is " + std::to_string(geometry.width) + " x " +
                                std::to_string(geometry.height) + " cells, expected at most " +
                                std::to_string(kMostMapCells) + " in all");
  }
}

}  // namespace map_matcher::grid
