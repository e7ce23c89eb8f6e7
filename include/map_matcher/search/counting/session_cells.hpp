/// \file
/// The occupied cells of a session map as one stage of the search sees them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::search {

/// Largest extent of a session map along its diagonal [cells of the stage]; positions are kept in 16 bits.
constexpr double kMaxSessionDiagonal = 30000.0;

/// Occupied cells of a session map, as points around the middle of their bounding box.
struct SessionCells {
  double resolution = 0.0;              ///< Edge length of the stage's cells [m].
  Eigen::Vector2d centre{0.0, 0.0};     ///< Middle of the bounding box of all occupied cells [m], session grid frame.
  std::vector<Eigen::Vector2d> points;  ///< Cell centres relative to `centre` [cells of the stage].
  double diagonal = 0.0;                ///< Diagonal of the bounding box, sqrt(i^2 + j^2) of eq. 4.2 [cells].
  int longest_side = 0;                 ///< max(i, j) of eq. 4.1 [cells].
};

/// Distance of the farthest point from the centre [cells]; 0 without points.
double farthestPoint(const SessionCells& session);

/// Number of downsampling steps H = log2(max(2 i, 2 j)) - 1 of eq. 4.1, at least 0: from this level on a node is about
/// as wide as the session map.
int downsamplingSteps(const SessionCells& session);

/// How session cells become points of a stage.
enum class CellMerging {
  kNone,   ///< Each session cell is a point of its own, at its centre.
  kMerge,  ///< Session cells that fall into the same, larger cell of the stage are one point (the max operator of
           ///< report section 3.1), which lies at their mean: the middle of the larger cell would be up to half of it
           ///< off the wall.
};

/// The session cells for a stage of a resolution [m]. The size of the session map is that of the bounding box of its
/// occupied cells, since slam_gmapping's map has a wide unknown border. `sample_threshold` > 0 keeps at most so many of
/// the points, always the same ones for the same cells. The points come in a fixed order: neighbourhoods of points that
/// lie beside each other, the neighbourhoods shuffled. `cells` must not be empty.
SessionCells prepareSessionCells(const std::vector<grid::Cell>& cells, double map_resolution, double resolution,
                                 CellMerging merging, int sample_threshold);

}  // namespace map_matcher::search
