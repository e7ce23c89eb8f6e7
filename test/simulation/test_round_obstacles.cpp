#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "map_matcher/simulation/round_obstacles.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr double kDegree = M_PI / 180.0;

/// 181 rays from the right over ahead to the left, a degree apart: ray 90 points ahead.
const RayFan kHalfTurn{-90.0 * kDegree, kDegree, 20.0};
const std::vector<double> kOpen(181, kNothing);

TEST(RoundObstacles, areMetWhereTheRaysEnterThem) {
  const RaysOnCircles met = castOnCircles({{{2.0, 0.0}, 0.1}}, {}, kHalfTurn, kOpen);
  EXPECT_NEAR(met.distances[90], 1.9, 1e-12);
  // The circle spans asin(0.1 / 2) = 2.866 degrees to either side. At 2 degrees: 2 cos 2 - sqrt(0.01 - (2 sin 2)^2).
  EXPECT_NEAR(met.distances[92], 1.927171, 1e-6);
  EXPECT_NEAR(met.distances[88], 1.927171, 1e-6);
  EXPECT_EQ(met.distances[93], kNothing);
  EXPECT_EQ(met.distances[87], kNothing);
  EXPECT_EQ(std::count(met.distances.begin(), met.distances.end(), kNothing), 181 - 5);
}

TEST(RoundObstacles, areSeenFromTheLidarsPose) {
  // From (1, 2), looking along y, the circle is 3 m to the left.
  const RaysOnCircles met = castOnCircles({{{-2.0, 2.0}, 0.5}}, {1.0, 2.0, M_PI / 2.0}, kHalfTurn, kOpen);
  EXPECT_NEAR(met.distances[180], 2.5, 1e-9);
  EXPECT_EQ(met.distances[90], kNothing);
}

TEST(RoundObstacles, hideWhatIsBehindThemAndAreHidden) {
  const std::vector<Circle> circles{{{3.0, 0.0}, 0.3}, {{2.0, 0.0}, 0.1}, {{5.0, 0.0}, 0.1}};
  std::vector<double> walls(181, 4.0);
  walls[95] = 2.5;
  const RaysOnCircles met = castOnCircles(circles, {}, kHalfTurn, walls);
  EXPECT_EQ(met.circles[90], 1U);
  EXPECT_NEAR(met.distances[90], 1.9, 1e-12);
  EXPECT_EQ(met.circles[94], 0U);  // past the front one, which spans 2.9 degrees; the middle one spans 5.7
  EXPECT_EQ(met.circles[95], std::nullopt);
  EXPECT_EQ(met.distances[95], 2.5);
  EXPECT_EQ(met.circles[97], std::nullopt);
  EXPECT_EQ(met.distances[97], 4.0);
}

TEST(RoundObstacles, acrossTheEndsOfAFullTurnAreSeenOnBothSides) {
  const RayFan full_turn{-180.0 * kDegree, kDegree, 20.0};
  const RaysOnCircles met = castOnCircles({{{-2.0, 0.0}, 0.1}}, {}, full_turn, std::vector<double>(360, kNothing));
  for (const std::size_t ray : {0U, 1U, 2U, 358U, 359U}) {
    EXPECT_LT(met.distances[ray], 2.0) << ray;
  }
  EXPECT_EQ(std::count(met.distances.begin(), met.distances.end(), kNothing), 360 - 5);
}

TEST(RoundObstacles, areSeenByRaysThatAreCountedFromAnotherAngleOrBackwards) {
  const std::vector<Circle> circles{{{0.0, -2.0}, 0.1}};  // at 270 degrees
  const std::vector<double> open(360, kNothing);
  EXPECT_NEAR(castOnCircles(circles, {}, {0.0, kDegree, 20.0}, open).distances[270], 1.9, 1e-9);
  EXPECT_NEAR(castOnCircles(circles, {}, {180.0 * kDegree, -kDegree, 20.0}, open).distances[270], 1.9, 1e-9);
}

TEST(RoundObstacles, outOfRangeAreNotSeen) {
  const RayFan near_sighted{-90.0 * kDegree, kDegree, 1.8};
  EXPECT_EQ(castOnCircles({{{2.0, 0.0}, 0.1}}, {}, near_sighted, kOpen).distances, kOpen);
}

TEST(RoundObstacles, aroundTheLidarLeaveItNothingToSee) {
  const RaysOnCircles met = castOnCircles({{{0.0, 0.05}, 0.1}}, {}, kHalfTurn, kOpen);
  EXPECT_EQ(std::count(met.distances.begin(), met.distances.end(), 0.0), 181);
}

/// Against every ray by every circle.
TEST(RoundObstacles, areMetAsByTheSlowWay) {
  RandomNumbers random(4);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Circle> circles;
    for (int i = 0; i < 40; ++i) {
      circles.push_back({{random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0)}, random.uniform(0.03, 0.4)});
    }
    const grid::Rigid2 T_map_lidar{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-3.0, 3.0)};
    const RayFan fan{random.uniform(-6.0, 3.0), 0.0058 * (trial % 2 == 0 ? 1.0 : -1.0), 20.0};
    const std::vector<double> walls(811, 5.0);
    const RaysOnCircles met = castOnCircles(circles, T_map_lidar, fan, walls);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const double heading = T_map_lidar.yaw + fan.angle_min + static_cast<double>(i) * fan.angle_increment;
      const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
      double expected = walls[i];
      for (const Circle& circle : circles) {
        const Eigen::Vector2d offset = circle.centre - T_map_lidar.translation();
        const double along = offset.dot(direction);
        const double root = circle.radius * circle.radius - (offset - along * direction).squaredNorm();
        if (offset.norm() <= circle.radius) {
          expected = 0.0;
        } else if (along > 0.0 && root >= 0.0) {
          expected = std::min(expected, along - std::sqrt(root));
        }
      }
      ASSERT_NEAR(met.distances[i], expected, 1e-6) << "ray " << i << " of trial " << trial;
    }
  }
}

/// Seven rays, 10 degrees apart.
scan::PlanarScan recordedScan() {
  return {-30.0 * kDegree, 10.0 * kDegree, 0.1, 8.0, {3.0F, 3.0F, 1.0F, 3.0F, 0.0F, NAN, 3.0F}};
}

TEST(InsertedCircles, hideWhatWasRecordedBehindThem) {
  RandomNumbers noise(1);
  const scan::PlanarScan scan = recordedScan();
  const LidarView view = insertCircles(scan, {{{2.0, 0.0}, 0.8}}, {}, 0.0, noise);  // spans 23.6 degrees
  const scan::PlanarScan& among = view.scan;
  EXPECT_EQ(view.rays_on, std::vector<int>{4});
  ASSERT_EQ(among.ranges.size(), 7U);
  EXPECT_EQ(among.ranges[0], 3.0F);
  EXPECT_LT(among.ranges[1], 2.0F);
  EXPECT_EQ(among.ranges[2], 1.0F);  // nearer than the circle
  EXPECT_FLOAT_EQ(among.ranges[3], 1.2F);
  EXPECT_NEAR(among.ranges[4], 1.248932, 1e-5);  // returned nothing before
  EXPECT_LT(among.ranges[5], 2.0F);
  EXPECT_EQ(among.ranges[6], 3.0F);
  EXPECT_EQ(among.angle_min, scan.angle_min);
  EXPECT_EQ(among.range_max, scan.range_max);
}

TEST(InsertedCircles, areMeasuredWithNoise) {
  RandomNumbers noise(1);
  double variance = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const scan::PlanarScan among = insertCircles(recordedScan(), {{{2.0, 0.0}, 0.1}}, {}, 0.03, noise).scan;
    variance += std::pow(static_cast<double>(among.ranges[3]) - 1.9, 2) / 4000.0;
  }
  EXPECT_NEAR(std::sqrt(variance), 0.03, 0.002);
}

TEST(InsertedCircles, thatAreNotInSightChangeNothing) {
  RandomNumbers noise(1);
  scan::PlanarScan scan = recordedScan();
  scan.ranges[5] = 2.5F;
  EXPECT_EQ(insertCircles(scan, {{{-2.0, 0.0}, 0.1}, {{6.0, 0.0}, 0.1}}, {}, 0.03, noise).scan.ranges, scan.ranges);
}

}  // namespace
}  // namespace map_matcher::simulation
