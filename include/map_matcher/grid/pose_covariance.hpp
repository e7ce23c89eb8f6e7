/// \file
/// How uncertain poses are.
#pragma once

#include <Eigen/Core>
#include <string>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::grid {

/// Covariance of (x, y, yaw) of T_a_b * T_b_c [m, m, rad], given that of T_a_b, for a T_b_c that is known exactly.
Eigen::Matrix3d covarianceOfProduct(const Rigid2& T_a_b, const Eigen::Matrix3d& covariance, const Rigid2& T_b_c);

/// How far two poses are apart by the covariance of (x, y, yaw) of their difference [m, m, rad], in deviations squared.
/// The covariance is positive definite.
double squaredDeviations(const Rigid2& a, const Rigid2& b, const Eigen::Matrix3d& covariance);

/// Why no pose can have this covariance of (x, y, yaw), with the value and what was expected; "" when one can.
std::string problemWithCovariance(const Eigen::Matrix3d& covariance);

}  // namespace map_matcher::grid
