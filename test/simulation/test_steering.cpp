#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/grid/resample.hpp"
#include "map_matcher/simulation/steering.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher {
namespace {

const World& hall() {
  static const World world(resample(test::asciiMap({"..........",  //
                                                    "..........",  //
                                                    "..........",  //
                                                    "..........",  //
                                                    "......#...",  //
                                                    "..........",  //
                                                    "..........",  //
                                                    ".........."}),
                                    0.05));
  return world;
}

const Mover kSelf{{2.0, 5.5}, {0.0, 0.0}, 0.2};
const Eigen::Vector2d kTarget(8.0, 5.5);

TEST(Steering, goesStraightWhereNothingIsInTheWay) {
  EXPECT_TRUE(steer(hall(), kSelf, kTarget, 1.2, {}).isApprox(Eigen::Vector2d(1.2, 0.0)));
}

TEST(Steering, getsPastSomebodyWhoStandsOnTheRight) {
  const Eigen::Vector2d wanted = steer(hall(), kSelf, kTarget, 1.2, {{{3.5, 5.5}, {0.0, 0.0}, 0.2}});
  EXPECT_LT(wanted.y(), -0.2);
  EXPECT_NEAR(wanted.norm(), 1.2, 1e-9);
}

TEST(Steering, letsSomebodyGoWhoWillBeAway) {
  const Eigen::Vector2d wanted = steer(hall(), kSelf, kTarget, 1.0, {{{3.5, 5.5}, {0.0, 1.0}, 0.2}});
  EXPECT_TRUE(wanted.isApprox(Eigen::Vector2d(1.0, 0.0)));
}

/// Surrounded at 0.25 m between the bodies: half of a second is to remain, so 0.25 m / 0.5 s at most.
TEST(Steering, slowsDownBeforeSomebodyWhoCannotBePassed) {
  std::vector<Mover> ring;
  for (int i = 0; i < 24; ++i) {
    const double angle = i * M_PI / 12.0;
    ring.push_back({kSelf.position + 0.65 * Eigen::Vector2d(std::cos(angle), std::sin(angle)), {0.0, 0.0}, 0.2});
  }
  const double speed = steer(hall(), kSelf, kTarget, 1.2, ring).norm();
  EXPECT_LE(speed, 0.55);
  EXPECT_GT(speed, 0.3);
}

TEST(Steering, doesNotWalkIntoSomebodyWhoIsTouched) {
  EXPECT_GT(std::abs(steer(hall(), kSelf, kTarget, 1.0, {{{2.4, 5.5}, {0.0, 0.0}, 0.2}}).y()), 0.5);
}

TEST(Steering, getsPastAPillar) {
  const Mover self{{4.5, 3.5}, {0.0, 0.0}, 0.2};
  const Eigen::Vector2d wanted = steer(hall(), self, {8.0, 3.5}, 1.0, {});
  const double slope = std::abs(wanted.y() / wanted.x());
  EXPECT_GT(slope, 0.2);  // the pillar is 1 m wide, 1.5 m ahead
  EXPECT_NEAR(wanted.norm(), 1.0, 1e-9);
}

}  // namespace
}  // namespace map_matcher
