/// \file
/// A rigid transform of the plane.
#pragma once

#include <Eigen/Core>

namespace map_matcher::grid {

/// Normalises an angle [rad] to (-pi, pi].
double normalizeAngle(double angle);

/// Rigid transform of the plane. `T_a_b` maps coordinates in b to coordinates in a: p_a = T_a_b * p_b.
struct Rigid2 {
  double x = 0.0;    ///< Translation along x [m].
  double y = 0.0;    ///< Translation along y [m].
  double yaw = 0.0;  ///< Rotation, counter-clockwise [rad]; results of this header are in (-pi, pi].

  /// T_b_a from T_a_b.
  Rigid2 inverse() const;

  /// Translation part [m].
  Eigen::Vector2d translation() const { return {x, y}; }

  /// Rotation part, a 2 x 2 orthonormal matrix.
  Eigen::Matrix2d rotation() const;
};

/// T_a_c = T_a_b * T_b_c.
Rigid2 operator*(const Rigid2& T_a_b, const Rigid2& T_b_c);

/// p_a = T_a_b * p_b [m].
Eigen::Vector2d operator*(const Rigid2& T_a_b, const Eigen::Vector2d& p_b);

}  // namespace map_matcher::grid
