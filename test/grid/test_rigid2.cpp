#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <string>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::grid {
namespace {

constexpr double kTolerance = 1e-12;

void expectNear(const Rigid2& actual, const Rigid2& expected, double tolerance = kTolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(normalizeAngle(actual.yaw - expected.yaw), 0.0, tolerance);
}

Rigid2 randomTransform(std::mt19937& random) {
  std::uniform_real_distribution<double> metres(-100.0, 100.0);
  std::uniform_real_distribution<double> radians(-M_PI, M_PI);
  return {metres(random), metres(random), radians(random)};
}

TEST(NormalizeAngle, KeepsAnglesInTheHalfOpenInterval) {
  EXPECT_EQ(normalizeAngle(0.0), 0.0);
  EXPECT_EQ(normalizeAngle(M_PI), M_PI);
  EXPECT_EQ(normalizeAngle(3.0), 3.0);
  EXPECT_EQ(normalizeAngle(-3.0), -3.0);
}

TEST(NormalizeAngle, TurnsMinusPiIntoPi) { EXPECT_EQ(normalizeAngle(-M_PI), M_PI); }

TEST(NormalizeAngle, TakesOffWholeTurns) {
  for (int turns = -1000; turns <= 1000; ++turns) {
    const double normalized = normalizeAngle(1.25 + turns * 2.0 * M_PI);
    EXPECT_NEAR(normalized, 1.25, 1e-11) << turns << " turns";
  }
}

TEST(Rigid2, TurnsCounterClockwiseAndThenShifts) {
  const Rigid2 T_a_b{10.0, 20.0, M_PI / 2.0};

  const Eigen::Vector2d p_a = T_a_b * Eigen::Vector2d(1.0, 0.0);

  EXPECT_NEAR(p_a.x(), 10.0, kTolerance);
  EXPECT_NEAR(p_a.y(), 21.0, kTolerance);
}

TEST(Rigid2, ComposesAsItsPointsDo) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const Rigid2 T_a_b = randomTransform(random);
    const Rigid2 T_b_c = randomTransform(random);
    const Eigen::Vector2d p_c(trial, -trial);

    const Eigen::Vector2d difference = (T_a_b * T_b_c) * p_c - T_a_b * (T_b_c * p_c);

    EXPECT_NEAR(difference.norm(), 0.0, 1e-10) << "trial " << trial;
  }
}

TEST(Rigid2, IsUndoneByItsInverseFromBothSides) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 100; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Rigid2 T_a_b = randomTransform(random);

    expectNear(T_a_b * T_a_b.inverse(), Rigid2{}, 1e-10);
    expectNear(T_a_b.inverse() * T_a_b, Rigid2{}, 1e-10);
  }
}

TEST(Rigid2, KeepsYawNormalizedWhenComposed) {
  const Rigid2 quarter{0.0, 0.0, 0.75 * M_PI};

  EXPECT_NEAR((quarter * quarter).yaw, -0.5 * M_PI, kTolerance);
  EXPECT_EQ((Rigid2{0.0, 0.0, M_PI}).inverse().yaw, M_PI);
}

TEST(Rigid2, HasAnOrthonormalRotation) {
  const Eigen::Matrix2d rotation = Rigid2{1.0, 2.0, 0.7}.rotation();

  EXPECT_TRUE((rotation * rotation.transpose()).isApprox(Eigen::Matrix2d::Identity()));
  EXPECT_NEAR(rotation.determinant(), 1.0, kTolerance);
}

}  // namespace
}  // namespace map_matcher::grid
