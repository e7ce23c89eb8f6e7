#include "map_matcher/grid/pose_covariance.hpp"

#include <Eigen/Cholesky>
#include <array>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::grid {

Eigen::Matrix3d covarianceOfProduct(const Rigid2& T_a_b, const Eigen::Matrix3d& covariance, const Rigid2& T_b_c) {
  // Turning b about its origin moves c along.
  const Eigen::Vector2d arm = T_a_b.rotation() * T_b_c.translation();
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -arm.y();
  jacobian(1, 2) = arm.x();
  return jacobian * covariance * jacobian.transpose();
}

double squaredDeviations(const Rigid2& a, const Rigid2& b, const Eigen::Matrix3d& covariance) {
  const Eigen::Vector3d difference(a.x - b.x, a.y - b.y, normalizeAngle(a.yaw - b.yaw));
  return difference.dot(covariance.ldlt().solve(difference));
}

std::string problemWithCovariance(const Eigen::Matrix3d& covariance) {
  constexpr std::array<const char*, 3> kNames{"x", "y", "yaw"};
  if (!covariance.allFinite()) {
    return "the covariance of x, y and yaw holds a value that is no finite number";
  }
  for (int n = 0; n < 3; ++n) {
    if (!(covariance(n, n) > 0.0)) {
      return std::string("the variance of ") + kNames.at(static_cast<std::size_t>(n)) + " is " +
             parameters::numberText(covariance(n, n)) + ", expected above 0";
    }
  }
  const Eigen::Vector3d scale = covariance.diagonal().cwiseSqrt().cwiseInverse();  // metres and radians alike
  const Eigen::Matrix3d correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
  if (!correlation.isApprox(correlation.transpose(), 1e-6)) {
    return "the covariance of x, y and yaw is not symmetric";
  }
  if (Eigen::LLT<Eigen::Matrix3d>(correlation).info() != Eigen::Success) {
    return "the covariance of x, y and yaw is not positive definite";
  }
  return "";
}

}  // namespace map_matcher::grid
