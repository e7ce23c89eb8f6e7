#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "map_matcher/localization/monte_carlo_localizer.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "support/ascii_map.hpp"
#include "support/drives.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Three rooms none of which is like another, or like itself when it is turned.
grid::OccupancyGrid building() {
  return grid::resample(test::asciiMap({"####################",  //
                                        "#.......#..........#",  //
                                        "#..................#",  //
                                        "#.##....#......###.#",  //
                                        "#.##....#......###.#",  //
                                        "#.......#..........#",  //
                                        "####..#####...######",  //
                                        "#.............#....#",  //
                                        "#.....##...........#",  //
                                        "#..........#..#....#",  //
                                        "####################"},
                                       0.5),
                        0.05);
}

MonteCarloOptions quickOptions() {
  MonteCarloOptions options;
  options.max_particles = 10000;
  return options;
}

const simulation::Drive& drive() {
  static const simulation::Drive driven = [] {
    simulation::DriveOptions options = test::shortDrive(3);
    options.duration = 40.0;
    options.rate = 5.0;
    options.lidar.beams = 181;
    options.min_waypoint_distance = 4.0;
    return simulation::simulateDrive(building(), options);
  }();
  return driven;
}

std::vector<scan::MountedScan> scansOf(const simulation::DriveStep& step) {
  return {{step.scans.front(), {drive().T_base_lidar.front(), false}}};
}

/// The estimate after the drive.
MonteCarloEstimate driven(const MonteCarloOptions& options, const grid::OccupancyGrid& map = building()) {
  MonteCarloLocalizer localizer(map, options);
  for (const simulation::DriveStep& step : drive().steps) {
    localizer.add(step.T_odom_base, scansOf(step));
  }
  return localizer.estimate();
}

class MonteCarlo : public testing::Test {
 protected:
  void SetUp() override {
    if (!MonteCarloLocalizer::available()) {
      GTEST_SKIP() << "MRPT is not in this build";
    }
  }
};

TEST_F(MonteCarlo, ConvergesToTheTruthFromAnywhere) {
  const MonteCarloEstimate start = MonteCarloLocalizer(building(), quickOptions()).estimate();
  EXPECT_GT(start.position_deviation, 2.0);
  EXPECT_GT(start.yaw_deviation, 1.0);
  EXPECT_EQ(start.particles, 10000);

  const MonteCarloEstimate end = driven(quickOptions());

  const grid::Rigid2 error = drive().steps.back().T_map_base.inverse() * end.T_map_base;
  EXPECT_LT(error.translation().norm(), 0.2);
  EXPECT_LT(std::abs(error.yaw), 0.1);
  EXPECT_LT(end.position_deviation, 0.3);
  EXPECT_LT(end.yaw_deviation, 0.2);
  EXPECT_LT(end.particles, 5000) << "KLD sampling needs fewer particles for a certain filter";
}

TEST_F(MonteCarlo, TakesAMapWhoseOriginIsTurned) {
  grid::OccupancyGrid turned = building();
  grid::GridGeometry geometry = turned.geometry();
  const grid::Rigid2 T_other_map{3.0, -2.0, 1.2};
  geometry.T_map_grid = T_other_map * geometry.T_map_grid;

  const MonteCarloEstimate end = driven(quickOptions(), {geometry, turned.values()});

  const grid::Rigid2 error = (T_other_map * drive().steps.back().T_map_base).inverse() * end.T_map_base;
  EXPECT_LT(error.translation().norm(), 0.2);
  EXPECT_LT(std::abs(error.yaw), 0.1);
}

TEST_F(MonteCarlo, TakesALaserThatHangsUpsideDown) {
  MonteCarloLocalizer localizer(building(), quickOptions());
  for (const simulation::DriveStep& step : drive().steps) {
    std::vector<scan::MountedScan> scans = scansOf(step);
    scans.front().mount.upside_down = true;
    std::reverse(scans.front().scan.ranges.begin(), scans.front().scan.ranges.end());
    localizer.add(step.T_odom_base, scans);
  }

  const grid::Rigid2 error = drive().steps.back().T_map_base.inverse() * localizer.estimate().T_map_base;
  EXPECT_LT(error.translation().norm(), 0.2);
}

TEST_F(MonteCarlo, IsTheSameForTheSameSeedOnly) {
  MonteCarloOptions options = quickOptions();
  options.max_particles = 2000;
  const MonteCarloEstimate once = driven(options);
  const MonteCarloEstimate again = driven(options);
  options.seed = 2;
  const MonteCarloEstimate other = driven(options);

  EXPECT_EQ(once.T_map_base.x, again.T_map_base.x);
  EXPECT_EQ(once.T_map_base.yaw, again.T_map_base.yaw);
  EXPECT_EQ(once.position_deviation, again.position_deviation);
  EXPECT_EQ(once.particles, again.particles);
  EXPECT_NE(once.T_map_base.x, other.T_map_base.x);
}

TEST_F(MonteCarlo, FollowsTheOdometryBetweenTwoUpdates) {
  MonteCarloLocalizer localizer(building(), quickOptions());
  const std::vector<scan::MountedScan> scans = scansOf(drive().steps.front());
  EXPECT_TRUE(localizer.add({0.0, 0.0, 0.0}, scans));
  const grid::Rigid2 before = localizer.estimate().T_map_base;

  EXPECT_FALSE(localizer.add({0.15, 0.0, 0.1}, scans)) << "the robot has moved too little";

  const grid::Rigid2 motion = before.inverse() * localizer.estimate().T_map_base;
  EXPECT_NEAR(motion.x, 0.15, 1e-9);
  EXPECT_NEAR(motion.yaw, 0.1, 1e-9);
  EXPECT_TRUE(localizer.add({0.25, 0.0, 0.1}, scans));
}

TEST_F(MonteCarlo, SurvivesScansThatMeasuredNothing) {
  MonteCarloLocalizer localizer(building(), quickOptions());
  std::vector<scan::MountedScan> nothing = scansOf(drive().steps.front());
  for (const float range : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 0.0F}) {
    nothing.front().scan.ranges.assign(181, range);
    EXPECT_FALSE(localizer.add({0.0, 0.0, 0.0}, nothing));
  }
  EXPECT_FALSE(localizer.add({0.0, 0.0, 0.0}, {}));
  EXPECT_TRUE(std::isfinite(localizer.estimate().T_map_base.x));
  EXPECT_TRUE(localizer.add({0.0, 0.0, 0.0}, scansOf(drive().steps.front())));

  EXPECT_FALSE(localizer.add({1.0, 0.0, 0.0}, nothing)) << "but the robot has moved";
  EXPECT_TRUE(localizer.add({1.0, 0.0, 0.0}, scansOf(drive().steps.front())));
  EXPECT_TRUE(std::isfinite(localizer.estimate().position_deviation));
}

TEST_F(MonteCarlo, StartsAnewWhenAskedTo) {
  MonteCarloLocalizer localizer(building(), quickOptions());
  localizer.add({0.0, 0.0, 0.0}, scansOf(drive().steps.front()));
  localizer.add({1.0, 0.0, 0.0}, scansOf(drive().steps.front()));

  localizer.reset();

  EXPECT_EQ(localizer.estimate().particles, 10000);
  EXPECT_GT(localizer.estimate().position_deviation, 2.0);
}

TEST(MonteCarloLocalizer, NamesEveryBadParameter) {
  MonteCarloOptions options;
  options.min_particles = 200;
  options.max_particles = 100;
  options.laser_sigma_hit = 0.0;

  EXPECT_THAT(test::thrownText<std::invalid_argument>([&] { MonteCarloLocalizer(building(), options); }),
              AllOf(HasSubstr("laser_sigma_hit is 0, expected 0.01 to 5"),
                    HasSubstr("min_particles is 200, expected at most max_particles = 100")));
}

TEST_F(MonteCarlo, RefusesAMapWithoutFreeSpace) {
  EXPECT_THAT(test::thrownText<std::invalid_argument>([] {
                MonteCarloLocalizer(test::asciiMap({"###", "#?#", "###"}, 0.5));
              }),
              HasSubstr("no free cell"));
}

TEST_F(MonteCarlo, RefusesOdometryThatIsNotFinite) {
  MonteCarloLocalizer localizer(building(), quickOptions());
  EXPECT_THROW(localizer.add({std::nan(""), 0.0, 0.0}, {}), std::invalid_argument);
}

TEST(MonteCarloLocalizer, SaysWhyItIsNotThere) {
  if (MonteCarloLocalizer::available()) {
    GTEST_SKIP() << "MRPT is in this build";
  }
  EXPECT_THAT(test::thrownText<std::runtime_error>([] { MonteCarloLocalizer localizer(building()); }),
              HasSubstr("MRPT (mrpt-slam) was not found when this was built"));
}

}  // namespace
}  // namespace map_matcher::localization
