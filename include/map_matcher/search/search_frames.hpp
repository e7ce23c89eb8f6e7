/// \file
/// Between the frames of the maps and the grids that are searched.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/search/constraints.hpp"
#include "map_matcher/search/counting/search_window.hpp"

namespace map_matcher::search {

/// Pose of the session cells' centre in the searched reference grid.
struct CentrePose {
  double angle = 0.0;                  ///< [rad]
  Eigen::Vector2d position{0.0, 0.0};  ///< [m]
};

/// Turns poses of the session's centre into poses of the session map frame and back.
class SearchFrames {
 public:
  SearchFrames(const grid::Rigid2& T_reference_grid, const grid::Rigid2& T_session_grid)
      : T_reference_grid_(T_reference_grid), T_session_grid_(T_session_grid) {}

  /// T_reference_session for a pose of the session's `centre` [m, session grid frame].
  grid::Rigid2 mapPose(const CentrePose& pose, const Eigen::Vector2d& centre) const;

  /// Covariance of (x, y, yaw) of T_reference_session [m, m, rad] from that of a pose of the session's `centre`.
  Eigen::Matrix3d mapCovariance(const Eigen::Matrix3d& covariance, double angle, const Eigen::Vector2d& centre) const;

  /// The pose of the session's `centre` [m, session grid frame] at T_reference_session.
  CentrePose centrePose(const grid::Rigid2& T_reference_session, const Eigen::Vector2d& centre) const;

  /// Angle of the session's cells in the reference grid at a yaw of T_reference_session [rad], not normalised.
  double angleAt(double yaw) const { return yaw - T_reference_grid_.yaw + T_session_grid_.yaw; }

  /// How far the session's cells at `angle` are from the prior's heading [rad], at least 0.
  double headingError(const HeadingPrior& prior, double angle) const;

  /// Translations [cells of `resolution`] at which the origin of the session map frame lies in the prior's box, or in
  /// the box around it along the axes of the reference grid where these are turned; all of them without a prior.
  SearchWindow window(const std::optional<WindowPrior>& prior, const Eigen::Vector2d& centre, double resolution,
                      double angle) const;

 private:
  grid::Rigid2 T_reference_grid_;
  grid::Rigid2 T_session_grid_;
};

}  // namespace map_matcher::search
