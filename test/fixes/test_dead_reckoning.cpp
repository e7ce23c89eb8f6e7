#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/fixes/dead_reckoning.hpp"
#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::fixes {
namespace {

constexpr double kDegree = M_PI / 180.0;  // [rad]

/// A fix that is as good as exact, of a robot at the session map's origin.
PoseEstimate exactFix() {
  PoseEstimate fix;
  fix.T_reference_base = {10.0, 5.0, M_PI / 2.0};
  fix.covariance = 1e-12 * Eigen::Matrix3d::Identity();
  fix.stamp = 100.0;
  return fix;
}

double sigma(const PoseEstimate& pose, int n) { return std::sqrt(pose.covariance(n, n)); }

/// Drives straight on in `steps` steps, as fast as it likes.
PoseEstimate afterDriving(double distance, int steps) {
  DeadReckoning robot(exactFix(), {});
  for (int n = 1; n <= steps; ++n) {
    robot.moveTo({distance * n / steps, 0.0, 0.0}, 100.0);
  }
  return robot.estimate();
}

TEST(DeadReckoning, FollowsTheRobotThroughTheReferenceMap) {
  DeadReckoning robot(exactFix(), {1.0, 1.0, 0.0});

  robot.moveTo({3.0, 1.0, 0.5}, 101.0);

  const PoseEstimate estimate = robot.estimate();
  EXPECT_NEAR(estimate.T_reference_base.x, 10.0, 1e-9);
  EXPECT_NEAR(estimate.T_reference_base.y, 7.0, 1e-9);
  EXPECT_NEAR(estimate.T_reference_base.yaw, M_PI / 2.0 + 0.5, 1e-9);
  EXPECT_EQ(estimate.stamp, 101.0);
}

TEST(DeadReckoning, IsLessCertainWithTheDistanceAsOdometryIs) {
  const PoseEstimate metre = afterDriving(1.0, 20);

  EXPECT_NEAR(sigma(metre, 1), 0.01, 0.001);  // along, which is y here
  EXPECT_NEAR(sigma(metre, 2), 0.6 * kDegree, 0.01 * kDegree);
  EXPECT_GT(sigma(afterDriving(10.0, 200), 0), 10.0 * sigma(metre, 0));  // a heading that is off takes the robot aside
}

TEST(DeadReckoning, GrowsAlikeHoweverOftenItIsAsked) {
  const PoseEstimate often = afterDriving(5.0, 400);
  const PoseEstimate seldom = afterDriving(5.0, 50);

  for (int n = 0; n < 3; ++n) {
    EXPECT_NEAR(sigma(often, n), sigma(seldom, n), 0.05 * sigma(often, n)) << n;
  }
}

TEST(DeadReckoning, IsLessCertainWithEveryTurn) {
  DeadReckoning robot(exactFix(), {});
  for (int n = 1; n <= 36; ++n) {
    robot.moveTo({0.0, 0.0, grid::normalizeAngle(n * 10.0 * kDegree)}, 100.0);
  }

  EXPECT_NEAR(sigma(robot.estimate(), 2), 2.0 * kDegree, 0.01 * kDegree);
}

TEST(DeadReckoning, IsLittleLessCertainOfARobotThatStandsAndTrembles) {
  DeadReckoning robot(exactFix(), {});
  for (int n = 1; n <= 600; ++n) {
    robot.moveTo({n % 2 == 0 ? 0.004 : -0.004, 0.0, 0.0}, 100.0 + 0.1 * n);
  }

  const PoseEstimate estimate = robot.estimate();
  EXPECT_GT(sigma(estimate, 2), 0.05 * kDegree);
  EXPECT_LT(sigma(estimate, 2), 0.3 * kDegree);
  EXPECT_LT(sigma(estimate, 0), 0.005);
  EXPECT_NEAR(estimate.T_reference_base.y, 5.004, 1e-9);
}

TEST(DeadReckoning, HasACovarianceThatAPoseCanHave) {
  EXPECT_EQ(grid::problemWithCovariance(afterDriving(100.0, 1000).covariance), "");
}

TEST(DeadReckoning, TakesNoTimeBackwards) {
  DeadReckoning robot(exactFix(), {});
  robot.moveTo({}, 90.0);

  EXPECT_EQ(robot.estimate().stamp, 100.0);
  EXPECT_TRUE(robot.estimate().covariance.isApprox(exactFix().covariance));
}

}  // namespace
}  // namespace map_matcher::fixes
