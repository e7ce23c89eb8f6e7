/// \file
/// What a map says of the places in it, walls and free space alike.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::grid {

/// What a map says of a place.
enum class Seen : std::uint8_t {
  kUnseen,    ///< Nothing, or nothing that is sure.
  kOpen,      ///< There is no wall, nor one within SeenSpace::kNear.
  kNearWall,  ///< There is a wall within SeenSpace::kNear.
};

/// A map's walls, and the free space that it was seen to have between them. Immutable, hence thread-safe.
class SeenSpace {
 public:
  /// How far from a wall its place may be in another map of the building: what mappers bend, and cells [m].
  static constexpr double kNear = 0.2;

  /// A wall is a cell of at least `occupied_threshold` [percent]; free is one of at most 100 less that. `cell_offset`
  /// as for cornerOf() [cells].
  SeenSpace(const OccupancyGrid& map, double cell_offset, int occupied_threshold);

  /// What is said of a place of the map frame [m].
  Seen at(const Eigen::Vector2d& p_map) const;

  /// Where walls stand, one point for a cell of their length [m, map frame]: their middle line, however thick they are
  /// drawn; of what is thicker than 2 * kNear, a line that far below its surface.
  const std::vector<Eigen::Vector2d>& walls() const { return walls_; }

  /// Edge length of a cell, the length of wall that a point stands for [m].
  double resolution() const { return geometry_.resolution; }

 private:
  GridGeometry geometry_;   // with the cell offset
  std::vector<Seen> seen_;  // row-major
  std::vector<Eigen::Vector2d> walls_;
};

}  // namespace map_matcher::grid
