#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/belief/prior.hpp"
#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::belief {
namespace {

TEST(Prior, PutsTheRobotWhereItIsSaidToBe) {
  const grid::Rigid2 T_session_base{4.0, -3.0, 2.0};
  Eigen::Matrix3d covariance;
  covariance << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.01;

  const Prior prior = priorOfRobot({10.0, 5.0, -1.0}, covariance, T_session_base, "initialpose");

  const grid::Rigid2 T_reference_base = prior.place.T_reference_session * T_session_base;
  EXPECT_NEAR(T_reference_base.x, 10.0, 1e-9);
  EXPECT_NEAR(T_reference_base.y, 5.0, 1e-9);
  EXPECT_NEAR(T_reference_base.yaw, -1.0, 1e-9);
  EXPECT_TRUE(grid::covarianceOfProduct(prior.place.T_reference_session, prior.covariance, T_session_base)
                  .isApprox(covariance, 1e-9));
  EXPECT_EQ(prior.source, "initialpose");
}

TEST(Prior, IsVagueFarFromTheRobot) {
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.01, 0.04).asDiagonal();

  const Prior prior = priorOfRobot({}, covariance, {10.0, 0.0, 0.0}, "initialpose");

  EXPECT_NEAR(prior.covariance(0, 0), 0.01, 1e-9);
  EXPECT_NEAR(prior.covariance(1, 1), 0.01 + 100.0 * 0.04, 1e-9);  // the heading turns the session about the robot
}

TEST(Prior, MeansAPlaceInItsOwnMapOnly) {
  const Eigen::Matrix3d covariance = 0.25 * Eigen::Matrix3d::Identity();
  const Prior prior = priorOfRobot({3.0, 4.0, 0.1}, covariance, {}, "initialpose", 1);

  EXPECT_TRUE(agrees(prior, {{3.5, 4.0, 0.1}, 1}));
  EXPECT_FALSE(agrees(prior, {{3.5, 4.0, 0.1}, 0}));
  EXPECT_EQ(priorEvidence(prior, {{3.5, 4.0, 0.1}, 0}).bearing, Bearing::kSilent);
  EXPECT_NE(priorEvidence(prior, {{3.5, 4.0, 0.1}, 0}).text.find("of another reference map"), std::string::npos);
}

}  // namespace
}  // namespace map_matcher::belief
