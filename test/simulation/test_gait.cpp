#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "map_matcher/simulation/gait.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kPeriod = 0.01;
constexpr double kHalfWidth = 0.09;

bool anywhere(const Eigen::Vector2d& /*foot*/) { return true; }

/// Somebody who walks along x at this speed.
struct Walk {
  explicit Walk(double speed) : velocity(speed, 0.0) {}

  void go(const Gait::Footing& footing = anywhere) {
    centre += velocity * kPeriod;
    gait.step(centre, 0.0, velocity, kPeriod, footing);
  }

  Eigen::Vector2d velocity;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Gait gait{centre, 0.0, kHalfWidth};
};

TEST(Gait, standsWithTheLeftFootOnTheLeft) {
  const Gait gait({1.0, 2.0}, M_PI / 2.0, kHalfWidth);  // looks along y
  EXPECT_TRUE(gait.feet()[0].isApprox(Eigen::Vector2d(1.0 - kHalfWidth, 2.0)));
  EXPECT_TRUE(gait.feet()[1].isApprox(Eigen::Vector2d(1.0 + kHalfWidth, 2.0)));
}

TEST(Gait, keepsTheStanceFootStillAndMovesTheOther) {
  Walk walk(1.2);
  for (int i = 0; i < 500; ++i) {
    const auto before = walk.gait.feet();
    const auto swing = walk.gait.swingFoot();
    walk.go();
    if (swing && walk.gait.swingFoot() == swing) {
      EXPECT_EQ(walk.gait.feet()[1 - *swing], before[1 - *swing]);
      EXPECT_GE(walk.gait.feet()[*swing].x(), before[*swing].x());
    }
  }
}

/// At 1.56 m/s a step is sqrt(0.39 * 1.56) = 0.78 m long and there are 2 steps a second, so that each foot has a stride
/// of 1.56 m each second.
TEST(Gait, takesStepsOfTheLengthAndFrequencyOfItsSpeed) {
  Walk walk(1.56);
  for (int i = 0; i < 300; ++i) {
    walk.go();
  }
  int num_landings = 0;
  double longest_step = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const auto swing = walk.gait.swingFoot();
    walk.go();
    if (walk.gait.swingFoot() != swing) {
      ++num_landings;
      longest_step = std::max(longest_step, std::abs(walk.gait.feet()[0].x() - walk.gait.feet()[1].x()));
    }
  }
  EXPECT_NEAR(num_landings, 20, 1);
  EXPECT_NEAR(longest_step, 0.78, 0.02);
}

/// Halfway through a step the swing foot passes the stance foot, at its highest speed: pi / 2 times a stride a step.
TEST(Gait, swingsAsASine) {
  Walk walk(1.56);
  double fastest = 0.0;
  double farthest_middle = 0.0;
  for (int i = 0; i < 600; ++i) {
    const auto before = walk.gait.feet();
    walk.go();
    if (i >= 300) {
      for (std::size_t foot = 0; foot < 2; ++foot) {
        fastest = std::max(fastest, (walk.gait.feet()[foot] - before[foot]).norm() / kPeriod);
      }
      const double middle = 0.5 * (walk.gait.feet()[0].x() + walk.gait.feet()[1].x());
      farthest_middle = std::max(farthest_middle, std::abs(middle - walk.centre.x()));
    }
  }
  EXPECT_NEAR(fastest, 0.5 * M_PI * 1.56 * 2.0, 0.05);
  EXPECT_LT(farthest_middle, 0.1);  // the body stays between the feet
}

TEST(Gait, closesTheLastStepAndStands) {
  Walk walk(1.2);
  for (int i = 0; i < 310; ++i) {
    walk.go();
  }
  walk.velocity.setZero();
  for (int i = 0; i < 400; ++i) {
    walk.go();
  }
  const auto stood = walk.gait.feet();
  EXPECT_FALSE(walk.gait.swingFoot());
  EXPECT_NEAR((stood[0] - walk.centre).norm(), kHalfWidth, 0.12);
  EXPECT_NEAR((stood[1] - walk.centre).norm(), kHalfWidth, 0.12);
  walk.go();
  EXPECT_EQ(walk.gait.feet(), stood);
}

TEST(Gait, putsNoFootWhereThereIsNoFooting) {
  Walk walk(1.2);
  const auto footing = [&](const Eigen::Vector2d& foot) { return foot.x() < 2.0; };
  while (walk.centre.x() < 1.9) {
    walk.go(footing);
    EXPECT_LT(walk.gait.feet()[0].x(), 2.0);
    EXPECT_LT(walk.gait.feet()[1].x(), 2.0);
  }
}

}  // namespace
}  // namespace map_matcher::simulation
