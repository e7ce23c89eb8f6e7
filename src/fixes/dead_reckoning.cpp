#include "map_matcher/fixes/dead_reckoning.hpp"

#include <algorithm>
#include <cmath>

#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::fixes {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;                                        // [rad]
constexpr double kVarianceAlong = 0.01 * 0.01;                                 // [m^2] after a metre
constexpr double kHeadingVariance = 0.6 * kDegree * 0.6 * kDegree;             // [rad^2] after a metre
constexpr double kTurnVariance = 2.0 * kDegree * 2.0 * kDegree / (2.0 * kPi);  // [rad^2] after a radian
constexpr double kCreeping = 0.001;                                            // of a robot that stands [m/s]
constexpr double kLeastDistance = 0.01;                                        // a robot that stands trembles on tf [m]
constexpr double kLeastTurn = 0.01;                                            // [rad]

}  // namespace

DeadReckoning::DeadReckoning(const PoseEstimate& fix, const grid::Rigid2& T_session_base)
    : counted_(fix), T_session_counted_(T_session_base), T_session_base_(T_session_base), stamp_(fix.stamp) {}

void DeadReckoning::moveTo(const grid::Rigid2& T_session_base, double stamp) {
  grow(kCreeping * std::max(0.0, stamp - stamp_), 0.0);
  stamp_ = std::max(stamp_, stamp);
  T_session_base_ = T_session_base;
  const grid::Rigid2 motion = T_session_counted_.inverse() * T_session_base;
  const double distance = motion.translation().norm();
  const double turn = std::abs(motion.yaw);
  if (distance < kLeastDistance && turn < kLeastTurn) {
    return;
  }
  counted_.covariance = grid::covarianceOfProduct(counted_.T_reference_base, counted_.covariance, motion);
  counted_.T_reference_base = counted_.T_reference_base * motion;
  T_session_counted_ = T_session_base;
  grow(distance, turn);
}

PoseEstimate DeadReckoning::estimate() const {
  return {counted_.T_reference_base * (T_session_counted_.inverse() * T_session_base_), counted_.covariance, stamp_};
}

void DeadReckoning::grow(double distance, double turn) {
  counted_.covariance(0, 0) += kVarianceAlong * distance;
  counted_.covariance(1, 1) += kVarianceAlong * distance;
  counted_.covariance(2, 2) += kHeadingVariance * distance + kTurnVariance * turn;
}

}  // namespace map_matcher::fixes
