#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/mapping/odometry_noise.hpp"

namespace map_matcher::mapping {
namespace {

double deviation(const PoseEstimate& estimate, int k) { return std::sqrt(estimate.covariance(k, k)); }

TEST(OdometryNoise, IsThatOfItsParametersAfterAMetreAndAfterARadian) {
  const OdometryNoise noise{0.1, 0.05, 0.04, 0.2};

  const PoseEstimate driven = moved({}, {1.0, 0.0, 0.0}, 0.0, noise);
  const PoseEstimate turned = moved({}, {0.0, 0.0, -1.0}, 0.0, noise);

  EXPECT_NEAR(deviation(driven, 0), 0.1, 1e-9);
  EXPECT_NEAR(deviation(driven, 1), 0.03, 1e-9);
  EXPECT_NEAR(deviation(driven, 2), 0.05, 1e-9);
  EXPECT_NEAR(deviation(turned, 0), 0.04, 1e-9);
  EXPECT_NEAR(deviation(turned, 2), 0.2, 1e-9);
}

TEST(OdometryNoise, TurnsWithTheRobot) {
  PoseEstimate start;
  start.T_session_base.yaw = M_PI / 2.0;

  const PoseEstimate driven = moved(start, {1.0, 0.0, 0.0}, 0.0, {0.1, 0.0, 0.0, 0.0});

  EXPECT_NEAR(driven.T_session_base.y, 1.0, 1e-9);
  EXPECT_NEAR(deviation(driven, 1), 0.1, 1e-9);
  EXPECT_NEAR(deviation(driven, 0), 0.03, 1e-9);
}

TEST(OdometryNoise, DoesNotDependOnHowAWayIsDivided) {
  const OdometryNoise noise{0.1, 0.0, 0.05, 0.0};
  PoseEstimate estimate;
  for (int i = 0; i < 100; ++i) {
    estimate = moved(estimate, {0.02, 0.0, 0.0}, 0.0, noise);
  }

  EXPECT_NEAR(deviation(estimate, 0), deviation(moved({}, {2.0, 0.0, 0.0}, 0.0, noise), 0), 1e-9);
}

TEST(OdometryNoise, LeadsAsideWhereTheHeadingIsNotSure) {
  PoseEstimate start;
  start.covariance(2, 2) = 0.1 * 0.1;

  EXPECT_NEAR(deviation(moved(start, {2.0, 0.0, 0.0}, 0.0, {0.0, 0.0, 0.0, 0.0}), 1), 0.2, 1e-9);
}

}  // namespace
}  // namespace map_matcher::mapping
