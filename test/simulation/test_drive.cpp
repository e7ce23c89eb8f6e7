#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "support/ascii_map.hpp"
#include "support/data_dir.hpp"
#include "support/drives.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using test::asciiMap;
using test::building;
using test::distanceDriven;
using test::expectNoCollision;
using test::longestStay;
using test::shortDrive;
using test::thrownText;
using test::twoRooms;

bool isOccupiedWithin(const grid::OccupancyGrid& map, const grid::Cell& cell, int distance) {
  for (int y = cell.y - distance; y <= cell.y + distance; ++y) {
    for (int x = cell.x - distance; x <= cell.x + distance; ++x) {
      if (map.geometry().contains({x, y}) && map.at(x, y) == grid::kOccupied) {
        return true;
      }
    }
  }
  return false;
}

class Drives : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Drives, throughBuildingsGoFarAndTouchNothing) {
  const grid::OccupancyGrid map = building(GetParam());
  DriveOptions options = shortDrive(GetParam());
  options.duration = 300.0;
  options.lidar.beams = 2;
  const Drive drive = simulateDrive(map, options);
  expectNoCollision(map, drive, options.robot.radius);
  EXPECT_LT(longestStay(drive), 10.0);
  EXPECT_GT(distanceDriven(drive), 120.0);
  EXPECT_GE(drive.visited.size(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Drives, testing::Range<std::uint64_t>(0, 8));

TEST(Drive, startsAndHeadsForPlacesInTheAreaAlone) {
  const grid::OccupancyGrid map = twoRooms();
  DriveOptions options = shortDrive(1);
  options.area = Rectangle{3.7, 0.0, 7.5, 4.0};  // the right room
  for (options.seed = 1; options.seed <= 10; ++options.seed) {
    const Drive drive = simulateDrive(map, options);
    EXPECT_TRUE(contains(*options.area, drive.steps.front().T_map_base.translation())) << "seed " << options.seed;
    EXPECT_GE(drive.visited.size(), 1U);
    for (const Eigen::Vector2d& place : drive.visited) {
      EXPECT_TRUE(contains(*options.area, place)) << place.transpose() << ", seed " << options.seed;
    }
  }
}

TEST(Drive, refusesAnAreaWithoutRoomForTheRobot) {
  DriveOptions options = shortDrive(1);
  options.area = Rectangle{3.4, 0.0, 3.6, 1.0};  // in the wall
  EXPECT_EQ(thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); }),
            "the map has no free place for a robot of radius 0.25 m in the area from (3.4, 0) m to (3.6, 1) m");
}

TEST(Drive, keepsToTheLimitsOfTheRobot) {
  const DriveOptions options = shortDrive(1);
  const Drive drive = simulateDrive(building(1), options);
  const double period = 1.0 / options.rate;
  EXPECT_EQ(drive.steps.front().velocity.linear, 0.0);
  for (std::size_t i = 1; i < drive.steps.size(); ++i) {
    const DriveStep& last = drive.steps[i - 1];
    const DriveStep& step = drive.steps[i];
    EXPECT_LE(step.velocity.linear, options.robot.max_speed);
    EXPECT_LE(std::abs(step.velocity.angular), options.robot.max_turn_rate);
    EXPECT_LE(std::abs(step.velocity.linear - last.velocity.linear), options.robot.max_acceleration * period + 1e-9);
    EXPECT_LE(std::abs(step.velocity.angular - last.velocity.angular),
              options.robot.max_turn_acceleration * period + 1e-9);
    EXPECT_LE((step.T_map_base.translation() - last.T_map_base.translation()).norm(),
              options.robot.max_speed * period + 1e-9);
  }
}

TEST(Drive, isSampledEvenlyFromItsStartToItsEnd) {
  DriveOptions options = shortDrive(1);
  options.rate = 12.5;
  const Drive drive = simulateDrive(building(1), options);
  ASSERT_EQ(drive.steps.size(), 376U);
  for (std::size_t i = 0; i < drive.steps.size(); ++i) {
    EXPECT_NEAR(drive.steps[i].time, static_cast<double>(i) * 0.08, 1e-9);
    EXPECT_EQ(drive.steps[i].scans.front().ranges.size(), 91U);
  }
}

TEST(Drive, isTheSameForTheSameSeed) {
  const grid::OccupancyGrid map = building(2);
  const Drive one = simulateDrive(map, shortDrive(5));
  const Drive other = simulateDrive(map, shortDrive(5));
  ASSERT_EQ(one.steps.size(), other.steps.size());
  for (std::size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_EQ(one.steps[i].scans.front().ranges, other.steps[i].scans.front().ranges);
    EXPECT_EQ(one.steps[i].T_map_base.x, other.steps[i].T_map_base.x);
    EXPECT_EQ(one.steps[i].T_odom_base.yaw, other.steps[i].T_odom_base.yaw);
  }
}

TEST(Drive, isAnotherForAnotherSeed) {
  const grid::OccupancyGrid map = building(2);
  const grid::Rigid2 one = simulateDrive(map, shortDrive(5)).steps.front().T_map_base;
  const grid::Rigid2 other = simulateDrive(map, shortDrive(6)).steps.front().T_map_base;
  EXPECT_GT((one.translation() - other.translation()).norm(), 0.05);
}

TEST(Drive, takesTheSameWayWhateverTheNoise) {
  const grid::OccupancyGrid map = building(2);
  DriveOptions options = shortDrive(5);
  const Drive noisy = simulateDrive(map, options);
  options.lidar.sigma = 0.0;
  options.odometry = {0.0, 0.0, 0.0, 0.0};
  const Drive exact = simulateDrive(map, options);
  EXPECT_EQ(noisy.steps.back().T_map_base.x, exact.steps.back().T_map_base.x);
  EXPECT_EQ(noisy.steps.back().T_map_base.y, exact.steps.back().T_map_base.y);
}

TEST(Drive, withoutNoiseHasTheTruthForItsOdometry) {
  DriveOptions options = shortDrive(3);
  options.odometry = {0.0, 0.0, 0.0, 0.0};
  const Drive drive = simulateDrive(building(3), options);
  const grid::Rigid2 T_start_map = drive.steps.front().T_map_base.inverse();
  for (const DriveStep& step : drive.steps) {
    const grid::Rigid2 expected = T_start_map * step.T_map_base;
    ASSERT_NEAR(step.T_odom_base.x, expected.x, 1e-9);
    ASSERT_NEAR(step.T_odom_base.y, expected.y, 1e-9);
    ASSERT_NEAR(grid::normalizeAngle(step.T_odom_base.yaw - expected.yaw), 0.0, 1e-9);
  }
}

TEST(Drive, hasScansThatFitTheMapAtTheTruePose) {
  const grid::OccupancyGrid map = building(3);
  DriveOptions options = shortDrive(3);
  options.lidar.sigma = 0.0;
  const Drive drive = simulateDrive(map, options);
  for (const DriveStep& step : drive.steps) {
    const grid::Rigid2 T_map_lidar = step.T_map_base * drive.T_base_lidar.front();
    for (std::size_t i = 0; i < step.scans.front().ranges.size(); ++i) {
      const double angle = step.scans.front().angle_min + static_cast<double>(i) * step.scans.front().angle_increment;
      const double range =
          static_cast<double>(step.scans.front().ranges[i]) + 1e-4;  // the surface of a cell, and a little more
      if (std::isfinite(range)) {
        const grid::Cell cell =
            map.geometry().cellAt(T_map_lidar * Eigen::Vector2d(range * std::cos(angle), range * std::sin(angle)));
        ASSERT_TRUE(isOccupiedWithin(map, cell, 1)) << "ray " << i << " at " << step.time << " s";
      }
    }
  }
}

TEST(Drive, withNoiseDriftsByAFewPercent) {
  const grid::OccupancyGrid map = building(3);
  double square = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    DriveOptions options = shortDrive(seed);
    options.lidar.beams = 2;
    const Drive drive = simulateDrive(map, options);
    const grid::Rigid2 truth = drive.steps.front().T_map_base.inverse() * drive.steps.back().T_map_base;
    const double error = (truth.translation() - drive.steps.back().T_odom_base.translation()).norm();
    square += std::pow(error / distanceDriven(drive), 2) / 20.0;
  }
  EXPECT_GT(std::sqrt(square), 0.005);
  EXPECT_LT(std::sqrt(square), 0.08);
}

TEST(Drive, visitsTheGivenWaypointsInTheirOrderAndEnds) {
  DriveOptions options = shortDrive(1);
  options.start = grid::Rigid2{1.5, 1.5, 2.0};
  options.waypoints = {{6.5, 2.5}, {2.5, 2.8}};
  options.duration = 200.0;
  const grid::OccupancyGrid map = twoRooms();
  const Drive drive = simulateDrive(map, options);

  EXPECT_EQ(drive.steps.front().T_map_base.x, 1.5);
  EXPECT_EQ(drive.steps.front().T_map_base.yaw, 2.0);
  EXPECT_EQ(drive.visited, options.waypoints);
  EXPECT_LT(drive.steps.back().time, 100.0);
  EXPECT_LT((drive.steps.back().T_map_base.translation() - options.waypoints[1]).norm(), 0.2);
  const auto nearest = std::min_element(drive.steps.begin(), drive.steps.end(), [](const auto& a, const auto& b) {
    const Eigen::Vector2d first(6.5, 2.5);
    return (a.T_map_base.translation() - first).norm() < (b.T_map_base.translation() - first).norm();
  });
  EXPECT_LT((nearest->T_map_base.translation() - options.waypoints[0]).norm(), 0.1);
  expectNoCollision(map, drive, options.robot.radius);
}

TEST(Drive, chooseRandomWaypointsFarApart) {
  DriveOptions options = shortDrive(4);
  options.duration = 300.0;
  options.lidar.beams = 2;
  options.min_waypoint_distance = 20.0;
  const Drive drive = simulateDrive(building(4), options);
  ASSERT_GE(drive.visited.size(), 2U);
  Eigen::Vector2d last = drive.steps.front().T_map_base.translation();
  for (const Eigen::Vector2d& waypoint : drive.visited) {
    EXPECT_GE((waypoint - last).norm(), 20.0);
    last = waypoint;
  }
}

TEST(Drive, refusesAWaypointThatCannotBeReached) {
  DriveOptions options = shortDrive(1);
  options.start = grid::Rigid2{1.5, 1.5, 0.0};
  options.waypoints = {{2.0, 2.0}, {3.75, 0.75}};
  const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); });
  EXPECT_NE(text.find("waypoint 2 is (3.75, 0.75) m"), std::string::npos) << text;
}

TEST(Drive, refusesAStartWithoutRoomForTheRobot) {
  DriveOptions options = shortDrive(1);
  options.start = grid::Rigid2{0.6, 1.5, 0.0};
  const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); });
  EXPECT_NE(text.find("start is (0.6, 1.5) m, expected a place with 0.25 m of free space"), std::string::npos) << text;
}

TEST(Drive, refusesAMapWithoutFreeSpace) {
  for (const grid::OccupancyGrid& map :
       {asciiMap({"####", "####"}), asciiMap({"    ", "    "}), asciiMap({"..", ".."}, 0.05)}) {
    const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(map, shortDrive(1)); });
    EXPECT_NE(text.find("no free place for a robot of radius 0.25 m"), std::string::npos) << text;
  }
}

TEST(Drive, namesEveryOptionOutOfItsRange) {
  DriveOptions options;
  options.duration = -1.0;
  options.rate = 0.0;
  options.lidar.beams = 0;
  options.robot.radius = 0.1;
  options.odometry.alpha2 = std::nan("");
  options.start = grid::Rigid2{std::nan(""), 0.0, 0.0};
  const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); });
  for (const char* problem :
       {"duration is -1, expected 0.1 to 36000 s", "rate is 0, expected 0.5 to 200 Hz", "beams is 0", "alpha2 is nan",
        "lidar_x, lidar_y are 0.15, 0, expected a place within radius (0.1 m)", "start is (nan, 0)"}) {
    EXPECT_NE(text.find(problem), std::string::npos) << problem << " is not in: " << text;
  }
}

TEST(Drive, worksInRecordedMaps) {
  const auto data = test::dataDir();
  if (!data) {
    GTEST_SKIP() << "the evaluation data is not here";
  }
  for (const char* name : {"asl_office", "intel", "freiburg-101"}) {
    SCOPED_TRACE(name);
    const grid::OccupancyGrid map = grid::loadMap((*data / "maps" / (std::string(name) + ".yaml")).string());
    DriveOptions options = shortDrive(2);
    options.duration = 120.0;
    const Drive drive = simulateDrive(map, options);
    expectNoCollision(map, drive, options.robot.radius);
    EXPECT_GT(distanceDriven(drive), 30.0);
    EXPECT_LT(longestStay(drive), 10.0);
  }
}

}  // namespace
}  // namespace map_matcher::simulation
