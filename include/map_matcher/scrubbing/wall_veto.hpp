/// \file
/// Tells detections on known walls, which are false, from people.
#pragma once

#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher {

/// Knows which places of a reference map are so near a wall that nobody can stand there. Immutable, hence thread-safe.
class WallVeto {
 public:
  /// `distance` [m], at least 0: from a place to the middle of the nearest wall cell; a person's legs keep some 15 cm
  /// from a wall. Throws std::invalid_argument for another distance or an empty map.
  WallVeto(const OccupancyGrid& reference, double distance, std::int8_t occupied_threshold = kDefaultOccupiedThreshold);

  /// Whether a place of the reference map frame [m] is within the distance of a wall, to the size of a cell. False
  /// outside the map.
  bool isOnWall(const Eigen::Vector2d& p_reference) const;

 private:
  GridGeometry geometry_;
  std::vector<std::uint8_t> near_wall_;  // row-major
};

}  // namespace map_matcher
