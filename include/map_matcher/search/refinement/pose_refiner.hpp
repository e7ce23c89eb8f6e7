/// \file
/// A pose finer than the grid, and how sure it is.
#pragma once

#include <Eigen/Core>

#include "map_matcher/search/counting/session_cells.hpp"
#include "map_matcher/search/refinement/distance_field.hpp"
#include "map_matcher/search/search_frames.hpp"

namespace map_matcher::search {

/// What a refinement came to.
struct RefinedPose {
  CentrePose pose;
  /// Covariance of the centre's position and the angle [m, m, rad], in the reference grid. In a direction in which the
  /// session may slide without leaving its walls, as in a corridor, the deviation is kPriorDeviation.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool converged = false;  ///< False: the pose is the one it began with.
};

/// Standard deviation where the walls tell nothing, so that a variance is never infinite [m]; of an angle, this is the
/// arc of a cell at the mean distance from the centre.
constexpr double kPriorDeviation = 1.0;

/// The distance beyond which a wall does not matter to a refinement [cells of `resolution` m].
double farthestThatMatters(double tolerance, double resolution);

/// Moves a pose to where the session cells lie best on the middle of the walls, by Gauss-Newton steps on a smooth field
/// of the distance to them. Cells farther than about `tolerance` [m] from a wall count little (weights of Geman and
/// McClure). A pose is moved by three times the tolerance at most, and not in a direction that the walls do not
/// determine. `walls` tells distances up to farthestThatMatters(). The covariance is that of least squares, with the
/// variance of the cells' distances, for as many independent cells as there are metres of wall: cells beside each other
/// err together, since both maps were drawn in whole cells.
RefinedPose refine(const DistanceField& walls, const SessionCells& session, const CentrePose& pose, double tolerance);

}  // namespace map_matcher::search
