#include "map_matcher/belief/prior.hpp"

#include <Eigen/Cholesky>

#include "map_matcher/grid/pose_covariance.hpp"
#include "pose_text.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kDeviations = 11.34;    // squared, that 99 % of poses lie within
constexpr double kLeastDeviation = 0.1;  // [m, rad] that a hand on a screen has

}  // namespace

Prior priorOfRobot(const grid::Rigid2& T_reference_base, const Eigen::Matrix3d& covariance,
                   const grid::Rigid2& T_session_base, const std::string& source, std::size_t map) {
  const grid::Rigid2 T_base_session = T_session_base.inverse();
  return {{T_reference_base * T_base_session, map},
          grid::covarianceOfProduct(T_reference_base, covariance, T_base_session),
          source};
}

bool agrees(const Prior& prior, const KnownPlace& place) {
  if (place.map != prior.place.map) {
    return false;
  }
  const grid::Rigid2& supposed = prior.place.T_reference_session;
  const grid::Rigid2& T = place.T_reference_session;
  const Eigen::Vector3d difference(T.x - supposed.x, T.y - supposed.y, grid::normalizeAngle(T.yaw - supposed.yaw));
  const Eigen::Matrix3d covariance = prior.covariance + kLeastDeviation * kLeastDeviation * Eigen::Matrix3d::Identity();
  return difference.dot(covariance.ldlt().solve(difference)) <= kDeviations;
}

Evidence priorEvidence(const Prior& prior, const KnownPlace& place) {
  Evidence evidence;
  evidence.name = "prior";
  evidence.value = 0.0;
  evidence.text = prior.source + " says that the session lies elsewhere, at " +
                  poseText(prior.place.T_reference_session) +
                  (place.map == prior.place.map ? "" : " of another reference map");
  if (agrees(prior, place)) {
    evidence.value = kPriorWorth;
    evidence.bearing = Bearing::kFor;
    evidence.text = prior.source + " says so, too";
  }
  return evidence;
}

}  // namespace map_matcher::belief
