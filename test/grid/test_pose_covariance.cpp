#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::grid {
namespace {

Eigen::Matrix3d exampleCovariance() {
  Eigen::Matrix3d covariance;
  covariance << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.01;
  return covariance;
}

TEST(PoseCovariance, OfAProductIsThatOfItsDerivative) {
  const Rigid2 T_a_b{3.0, -2.0, 0.7};
  const Rigid2 T_b_c{5.0, 1.5, -1.2};
  constexpr double kStep = 1e-6;
  Eigen::Matrix3d derivative;
  for (int n = 0; n < 3; ++n) {
    Rigid2 moved = T_a_b;
    (n == 0 ? moved.x : n == 1 ? moved.y : moved.yaw) += kStep;
    const Rigid2 there = moved * T_b_c;
    const Rigid2 here = T_a_b * T_b_c;
    derivative.col(n) << (there.x - here.x) / kStep, (there.y - here.y) / kStep, (there.yaw - here.yaw) / kStep;
  }

  const Eigen::Matrix3d actual = covarianceOfProduct(T_a_b, exampleCovariance(), T_b_c);

  EXPECT_TRUE(actual.isApprox(derivative * exampleCovariance() * derivative.transpose(), 1e-5)) << actual;
}

TEST(PoseCovariance, CanBeThatOfAPose) { EXPECT_EQ(problemWithCovariance(exampleCovariance()), ""); }

TEST(PoseCovariance, OfNothingIsTold) {
  EXPECT_EQ(problemWithCovariance(Eigen::Matrix3d::Zero()), "the variance of x is 0, expected above 0");
}

TEST(PoseCovariance, ThatIsNegativeIsTold) {
  Eigen::Matrix3d covariance = exampleCovariance();
  covariance(2, 2) = -0.5;

  EXPECT_EQ(problemWithCovariance(covariance), "the variance of yaw is -0.5, expected above 0");
}

TEST(PoseCovariance, ThatIsNoNumberIsTold) {
  Eigen::Matrix3d covariance = exampleCovariance();
  covariance(0, 1) = std::numeric_limits<double>::quiet_NaN();

  EXPECT_NE(problemWithCovariance(covariance).find("no finite number"), std::string::npos);
}

TEST(PoseCovariance, ThatIsNotSymmetricOrContradictsItselfIsTold) {
  Eigen::Matrix3d crooked = exampleCovariance();
  crooked(0, 1) = 0.02;
  Eigen::Matrix3d contradicting = exampleCovariance();
  contradicting(0, 1) = contradicting(1, 0) = 0.5;

  EXPECT_NE(problemWithCovariance(crooked).find("not symmetric"), std::string::npos);
  EXPECT_NE(problemWithCovariance(contradicting).find("not positive definite"), std::string::npos);
}

}  // namespace
}  // namespace map_matcher::grid
