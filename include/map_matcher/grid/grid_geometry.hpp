/// \file
/// Where the cells of a grid lie in its map frame.
#pragma once

#include <Eigen/Core>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::grid {

/// Column and row of a cell. x counts columns, y counts rows, both from the lower left corner [cells].
struct Cell {
  int x = 0;
  int y = 0;
};

inline bool operator==(const Cell& a, const Cell& b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(const Cell& a, const Cell& b) { return !(a == b); }

/// The farthest cell from the first one, along an axis and either way [cells]. Sums and differences of two such numbers
/// are numbers, too.
constexpr int kFarthestCell = 1'000'000'000;

/// Cell that holds a point [m] of the frame at whose origin cell (0, 0) begins, by floor; along an axis along which the
/// point lies farther off than kFarthestCell it is that, and along one along which the point is not a number
/// -kFarthestCell.
Cell cellOf(const Eigen::Vector2d& point, double resolution);

/// Size, resolution and pose of a grid, as nav_msgs/MapMetaData has them.
struct GridGeometry {
  double resolution = 0.05;  ///< Edge length of a cell [m], positive and finite.
  int width = 0;             ///< Number of columns [cells], at least 1.
  int height = 0;            ///< Number of rows [cells], at least 1.
  Rigid2 T_map_grid;         ///< Pose of the outer corner of cell (0, 0) in the map frame; any yaw.

  /// Centre of a cell in the map frame [m]. The cell may lie outside the grid.
  Eigen::Vector2d cellCentre(const Cell& cell) const;

  /// Cell that holds a point of the map frame [m], as cellOf(); it may lie outside the grid.
  Cell cellAt(const Eigen::Vector2d& p_map) const;

  /// Whether a cell lies inside the grid.
  bool contains(const Cell& cell) const { return cell.x >= 0 && cell.y >= 0 && cell.x < width && cell.y < height; }

  /// Throws std::invalid_argument, with the name and value of the offending field, unless the resolution is positive
  /// and finite, width and height are at least 1, there are at most 2^31 - 1 cells and the pose is finite.
  void validate() const;
};

/// Pose of a grid's corner in its map's frame, where the map draws all by `cell_offset` cells too far along +x and +y
/// of the grid.
Rigid2 cornerOf(const GridGeometry& geometry, double cell_offset);

}  // namespace map_matcher::grid
