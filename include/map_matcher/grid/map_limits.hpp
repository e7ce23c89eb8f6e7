/// \file
/// What a map that comes from outside, as a file or a message, has to keep to. Beyond that lies no building: it is a
/// mistake of units, or a value that nobody set.
#pragma once

#include <cstdint>

#include "map_matcher/grid/grid_geometry.hpp"

namespace map_matcher::grid {

constexpr double kMinMapResolution = 0.001;                     ///< [m]
constexpr double kMaxMapResolution = 10.0;                      ///< [m]
constexpr double kMaxMapOrigin = 1e6;                           ///< [m] along x and y, either way.
constexpr std::int64_t kMostMapCells = std::int64_t{1} << 28U;  ///< 800 m x 800 m in cells of 5 cm.

/// Throws std::invalid_argument, with the name and value of the field and what was expected, unless the geometry is
/// valid (GridGeometry::validate()) and within the limits.
void requireMapLimits(const GridGeometry& geometry);

}  // namespace map_matcher::grid
