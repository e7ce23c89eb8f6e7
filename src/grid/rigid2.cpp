#include "map_matcher/grid/rigid2.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace map_matcher::grid {

double normalizeAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * M_PI);  // in [-pi, pi]
  return wrapped <= -M_PI ? M_PI : wrapped;
}

Eigen::Matrix2d Rigid2::rotation() const { return Eigen::Rotation2Dd(yaw).toRotationMatrix(); }

Rigid2 Rigid2::inverse() const {
  const Eigen::Vector2d t = -(rotation().transpose() * translation());
  return {t.x(), t.y(), normalizeAngle(-yaw)};
}

Rigid2 operator*(const Rigid2& T_a_b, const Rigid2& T_b_c) {
  const Eigen::Vector2d t = T_a_b * T_b_c.translation();
  return {t.x(), t.y(), normalizeAngle(T_a_b.yaw + T_b_c.yaw)};
}

Eigen::Vector2d operator*(const Rigid2& T_a_b, const Eigen::Vector2d& p_b) {
  return T_a_b.rotation() * p_b + T_a_b.translation();
}

}  // namespace map_matcher::grid
