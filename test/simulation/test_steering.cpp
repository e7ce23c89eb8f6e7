#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "map_matcher/grid/resample.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/steering.hpp"
#include "support/ascii_map.hpp"
#include "support/steering_oracle.hpp"

namespace map_matcher::simulation {
namespace {

const World& hall() {
  static const World world(grid::resample(test::asciiMap({"..........",  //
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

/// It does not look at everybody and every wall in all directions, but decides as if it did.
TEST(Steering, decidesAsWhoLooksAtEverybodyAndEveryWall) {
  RandomNumbers random(11);
  int num_slowed = 0;
  int num_turned = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d place(random.uniform(0.5, 9.5), random.uniform(0.5, 7.5));
    const Mover self{place, {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)}, 0.2};
    const Eigen::Vector2d target = place + Eigen::Vector2d(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
    const double speed = random.uniform(0.2, 1.4);
    std::vector<Mover> others(random.index(40));
    for (Mover& other : others) {  // some of them touched, some on their way, some standing
      const Eigen::Vector2d offset(random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5));
      const double pace = random.chance(0.3) ? 0.0 : 1.0;
      other = {place + offset, pace * Eigen::Vector2d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)), 0.2};
    }
    const Eigen::Vector2d decided = steer(hall(), self, target, speed, others);
    const Eigen::Vector2d expected = test::steerByTheRules(hall(), self, target, speed, others);
    ASSERT_LT((decided - expected).norm(), 1e-9) << "scene " << i;
    num_slowed += decided.norm() < 0.99 * speed ? 1 : 0;
    num_turned += decided.normalized().dot((target - place).normalized()) < 0.9 ? 1 : 0;
  }
  EXPECT_GT(num_slowed, 100);
  EXPECT_GT(num_turned, 100);
}

}  // namespace
}  // namespace map_matcher::simulation
