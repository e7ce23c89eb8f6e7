/// \file
/// Which places of a map are beside a wall.
#pragma once

#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::grid {

/// The places of a map that are within a distance of a wall. Immutable, hence thread-safe.
class NearWalls {
 public:
  /// `distance` [m], at least 0: from the middle of a place's cell to the middle of the nearest wall cell. Throws
  /// std::invalid_argument for another distance.
  NearWalls(const OccupancyGrid& map, double distance, std::int8_t occupied_threshold = kDefaultOccupiedThreshold);

  /// Whether a place of the map frame [m] is within the distance of a wall. False outside the map.
  bool isNearWall(const Eigen::Vector2d& p_map) const;

 private:
  GridGeometry geometry_;
  std::vector<std::uint8_t> near_wall_;  // row-major
};

}  // namespace map_matcher::grid
