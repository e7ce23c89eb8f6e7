#include "map_matcher/mapping/odometry_noise.hpp"

#include <algorithm>
#include <cmath>

#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::mapping {
namespace {

constexpr double kCreep = 0.001;   // [m], standard deviation of a robot that stands for a second
constexpr double kTwist = 0.0005;  // [rad], of its heading

}  // namespace

PoseEstimate moved(const PoseEstimate& estimate, const grid::Rigid2& motion, double duration,
                   const OdometryNoise& noise) {
  const Eigen::Vector2d way = estimate.T_session_base.rotation() * motion.translation();
  const double distance = way.norm();
  const double turn = std::abs(motion.yaw);
  const double time = std::clamp(duration, 0.0, 1.0);
  const double along = noise.srr * noise.srr * distance;
  const double beside = kSidewaysShare * kSidewaysShare * along;
  const double everywhere = noise.str * noise.str * turn + kCreep * kCreep * time;
  const Eigen::Vector2d direction = distance > 0.0 ? Eigen::Vector2d(way / distance) : Eigen::Vector2d::Zero();

  PoseEstimate after;
  after.T_session_base = estimate.T_session_base * motion;
  after.covariance = grid::covarianceOfProduct(estimate.T_session_base, estimate.covariance, motion);
  after.covariance.topLeftCorner<2, 2>() +=
      (along - beside) * direction * direction.transpose() + (beside + everywhere) * Eigen::Matrix2d::Identity();
  after.covariance(2, 2) += noise.srt * noise.srt * distance + noise.stt * noise.stt * turn + kTwist * kTwist * time;
  return after;
}

}  // namespace map_matcher::mapping
