#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "map_matcher/simulation/lidar.hpp"
#include "support/ascii_map.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using test::asciiMap;
using test::thrownText;

constexpr float kNoReturn = std::numeric_limits<float>::infinity();

/// Three rays, to the right, ahead and to the left, from the middle of the robot.
LidarOptions threeRays() {
  LidarOptions options;
  options.beams = 3;
  options.field_of_view = M_PI;
  options.sigma = 0.0;
  options.T_base_lidar = {};
  return options;
}

Lidar lidarWith(const LidarOptions& options, std::uint64_t seed = 1) { return Lidar(options, RandomNumbers(seed)); }

TEST(Lidar, spreadsItsRaysFromRightToLeftOverTheFieldOfView) {
  const World world(asciiMap({"#####",  //
                              ".....",  //
                              ".....",  //
                              ".....",  //
                              "....#",  //
                              "#####"}));
  const scan::PlanarScan scan = lidarWith(threeRays()).scan(world, {0.5, 1.5, 0.0});
  ASSERT_EQ(scan.ranges.size(), 3U);
  EXPECT_DOUBLE_EQ(scan.angle_min, -M_PI / 2.0);
  EXPECT_DOUBLE_EQ(scan.angle_increment, M_PI / 2.0);
  EXPECT_NEAR(scan.ranges[0], 0.5, 1e-6);
  EXPECT_NEAR(scan.ranges[1], 3.5, 1e-6);
  EXPECT_NEAR(scan.ranges[2], 3.5, 1e-6);
}

TEST(Lidar, hasTheReportsFieldOfViewAndRangeByDefault) {
  const World world(asciiMap({"...#"}));
  const scan::PlanarScan scan = lidarWith({}).scan(world, {0.5, 0.5, 0.0});
  EXPECT_EQ(scan.ranges.size(), 811U);
  EXPECT_NEAR(scan.angle_min, -135.0 * M_PI / 180.0, 1e-12);
  EXPECT_NEAR(scan.angle_increment, M_PI / 180.0 / 3.0, 1e-12);
  EXPECT_EQ(scan.range_max, 20.0);
  EXPECT_EQ(scan.range_min, 0.05);
}

TEST(Lidar, looksFromItsMountingPose) {
  const World world(asciiMap({"........#"}));
  LidarOptions options = threeRays();
  options.T_base_lidar = {1.0, 0.0, M_PI / 2.0};
  const scan::PlanarScan scan = lidarWith(options).scan(world, {0.5, 0.5, 0.0});
  EXPECT_NEAR(scan.ranges[0], 6.5, 1e-6);  // its right is the robot's front
  EXPECT_EQ(scan.ranges[1], kNoReturn);
}

TEST(Lidar, doesNotSeeWhatIsHiddenOrOutOfRange) {
  const World world(asciiMap({"..#..#", "......", ".....#"}));
  LidarOptions options = threeRays();
  options.range_max = 5.0;
  EXPECT_NEAR(lidarWith(options).scan(world, {0.5, 2.5, 0.0}).ranges[1], 1.5, 1e-6);
  EXPECT_NEAR(lidarWith(options).scan(world, {0.5, 0.5, 0.0}).ranges[1], 4.5, 1e-6);
  options.range_max = 4.0;
  EXPECT_EQ(lidarWith(options).scan(world, {0.5, 0.5, 0.0}).ranges[1], kNoReturn);
}

TEST(Lidar, getsNothingBackFromNearerThanRangeMin) {
  const World world(asciiMap({".#"}));
  LidarOptions options = threeRays();
  options.range_min = 0.2;
  EXPECT_EQ(lidarWith(options).scan(world, {0.9, 0.5, 0.0}).ranges[1], kNoReturn);
  EXPECT_NEAR(lidarWith(options).scan(world, {0.7, 0.5, 0.0}).ranges[1], 0.3, 1e-6);
}

TEST(Lidar, measuresWithNormallyDistributedNoise) {
  const World world(asciiMap({"..........#"}));
  LidarOptions options = threeRays();
  options.sigma = 0.05;
  Lidar lidar = lidarWith(options, 5);
  constexpr int kScans = 20000;
  double mean = 0.0;
  double variance = 0.0;
  for (int i = 0; i < kScans; ++i) {
    const double error = static_cast<double>(lidar.scan(world, {0.5, 0.5, 0.0}).ranges[1]) - 9.5;
    mean += error / kScans;
    variance += error * error / kScans;
  }
  EXPECT_NEAR(mean, 0.0, 0.0015);  // four standard deviations
  EXPECT_NEAR(std::sqrt(variance), 0.05, 0.001);
}

TEST(Lidar, seesTheSameWithTheSameSeedOnly) {
  const World world(asciiMap({"..........#"}));
  LidarOptions options = threeRays();
  options.sigma = 0.05;
  const grid::Rigid2 pose{0.5, 0.5, 0.0};
  EXPECT_EQ(lidarWith(options, 5).scan(world, pose).ranges, lidarWith(options, 5).scan(world, pose).ranges);
  EXPECT_NE(lidarWith(options, 5).scan(world, pose).ranges, lidarWith(options, 6).scan(world, pose).ranges);
}

TEST(Lidar, seesLegsBeforeWallsAndCountsItsRaysOnThem) {
  const World world(asciiMap({".........#"}));
  LidarOptions options = threeRays();
  options.range_max = 10.0;
  const std::vector<Circle> legs{{{4.5, 0.5}, 0.1}, {{6.5, 0.5}, 0.1}, {{0.5, 0.8}, 0.1}};
  const LidarView view = lidarWith(options).scanAmong(legs, world, {0.5, 0.5, 0.0});
  EXPECT_EQ(view.scan.ranges[0], kNoReturn);
  EXPECT_NEAR(view.scan.ranges[1], 3.9, 1e-6);
  EXPECT_NEAR(view.scan.ranges[2], 0.2, 1e-6);
  EXPECT_EQ(view.rays_on, (std::vector<int>{1, 0, 1}));
}

/// The noise of a ray does not depend on what it meets, so the rays past the legs are the same with them.
TEST(Lidar, seesTheRestAsWithoutTheLegs) {
  const World world(asciiMap({".........#"}));
  LidarOptions options;
  options.T_base_lidar = {};
  const grid::Rigid2 pose{0.5, 0.5, 0.0};
  const scan::PlanarScan without = lidarWith(options, 3).scan(world, pose);
  const LidarView with = lidarWith(options, 3).scanAmong({{{3.5, 0.5}, 0.07}}, world, pose);
  int num_changed = 0;
  for (std::size_t i = 0; i < without.ranges.size(); ++i) {
    num_changed += without.ranges[i] == with.scan.ranges[i] ? 0 : 1;
  }
  EXPECT_EQ(num_changed, 9);  // a circle of 0.07 m at 3 m spans 1.337 degrees to either side, a ray each third
  EXPECT_EQ(with.rays_on, (std::vector<int>{9}));
}

TEST(Lidar, namesEveryOptionOutOfItsRange) {
  LidarOptions options;
  options.beams = 1;
  options.field_of_view = 7.0;
  options.range_min = -0.1;
  options.range_max = std::nan("");
  options.sigma = -0.03;
  const std::string text = thrownText<std::invalid_argument>([&] { lidarWith(options); });
  for (const char* problem :
       {"beams is 1, expected 2 to 100000", "field_of_view is 7, expected 0.01 to 6.2832 rad",
        "range_min is -0.1, expected 0 to 1 m", "range_max is nan, expected 1 to 1000 m", "sigma is -0.03"}) {
    EXPECT_NE(text.find(problem), std::string::npos) << problem << " is not in: " << text;
  }
}

}  // namespace
}  // namespace map_matcher::simulation
