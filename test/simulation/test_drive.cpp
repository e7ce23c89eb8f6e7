#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/grid/resample.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "support/ascii_map.hpp"
#include "support/data_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher {
namespace {

using test::asciiMap;
using test::thrownText;

OccupancyGrid building(std::uint64_t seed) {
  OfficeBuildingOptions options;
  options.seed = seed;
  return officeBuilding(options);
}

DriveOptions shortDrive(std::uint64_t seed) {
  DriveOptions options;
  options.seed = seed;
  options.duration = 30.0;
  options.lidar.beams = 91;
  return options;
}

double distanceDriven(const Drive& drive) {
  double distance = 0.0;
  for (std::size_t i = 1; i < drive.steps.size(); ++i) {
    distance += (drive.steps[i].T_map_base.translation() - drive.steps[i - 1].T_map_base.translation()).norm();
  }
  return distance;
}

/// Whether a circle touches a cell that is not free, by looking at every cell near it.
bool touchesSomething(const OccupancyGrid& grid, const Eigen::Vector2d& p_map, double radius) {
  const GridGeometry& geometry = grid.geometry();
  const Eigen::Vector2d p = geometry.T_map_grid.inverse() * p_map / geometry.resolution;
  const double r = radius / geometry.resolution;
  for (int y = static_cast<int>(std::floor(p.y() - r)); y <= static_cast<int>(std::floor(p.y() + r)); ++y) {
    for (int x = static_cast<int>(std::floor(p.x() - r)); x <= static_cast<int>(std::floor(p.x() + r)); ++x) {
      const double dx = std::max({x - p.x(), 0.0, p.x() - (x + 1)});
      const double dy = std::max({y - p.y(), 0.0, p.y() - (y + 1)});
      const bool is_free =
          geometry.contains({x, y}) && grid.at(x, y) >= kFree && grid.at(x, y) < kDefaultOccupiedThreshold;
      if (!is_free && std::hypot(dx, dy) < r) {
        return true;
      }
    }
  }
  return false;
}

void expectNoCollision(const OccupancyGrid& map, const Drive& drive, double radius) {
  for (const DriveStep& step : drive.steps) {
    ASSERT_FALSE(touchesSomething(map, step.T_map_base.translation(), radius))
        << "at " << step.time << " s in (" << step.T_map_base.x << ", " << step.T_map_base.y << ")";
  }
}

/// The longest time that the robot stays within 0.3 m [s].
double longestStay(const Drive& drive) {
  double longest = 0.0;
  const DriveStep* here = &drive.steps.front();
  for (const DriveStep& step : drive.steps) {
    if ((step.T_map_base.translation() - here->T_map_base.translation()).norm() > 0.3) {
      here = &step;
    }
    longest = std::max(longest, step.time - here->time);
  }
  return longest;
}

bool isOccupiedWithin(const OccupancyGrid& map, const Cell& cell, int distance) {
  for (int y = cell.y - distance; y <= cell.y + distance; ++y) {
    for (int x = cell.x - distance; x <= cell.x + distance; ++x) {
      if (map.geometry().contains({x, y}) && map.at(x, y) == kOccupied) {
        return true;
      }
    }
  }
  return false;
}

class Drives : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Drives, throughBuildingsGoFarAndTouchNothing) {
  const OccupancyGrid map = building(GetParam());
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
  const OccupancyGrid map = building(2);
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
  const OccupancyGrid map = building(2);
  const Rigid2 one = simulateDrive(map, shortDrive(5)).steps.front().T_map_base;
  const Rigid2 other = simulateDrive(map, shortDrive(6)).steps.front().T_map_base;
  EXPECT_GT((one.translation() - other.translation()).norm(), 0.05);
}

TEST(Drive, takesTheSameWayWhateverTheNoise) {
  const OccupancyGrid map = building(2);
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
  const Rigid2 T_start_map = drive.steps.front().T_map_base.inverse();
  for (const DriveStep& step : drive.steps) {
    const Rigid2 expected = T_start_map * step.T_map_base;
    ASSERT_NEAR(step.T_odom_base.x, expected.x, 1e-9);
    ASSERT_NEAR(step.T_odom_base.y, expected.y, 1e-9);
    ASSERT_NEAR(normalizeAngle(step.T_odom_base.yaw - expected.yaw), 0.0, 1e-9);
  }
}

TEST(Drive, hasScansThatFitTheMapAtTheTruePose) {
  const OccupancyGrid map = building(3);
  DriveOptions options = shortDrive(3);
  options.lidar.sigma = 0.0;
  const Drive drive = simulateDrive(map, options);
  for (const DriveStep& step : drive.steps) {
    const Rigid2 T_map_lidar = step.T_map_base * drive.T_base_lidar.front();
    for (std::size_t i = 0; i < step.scans.front().ranges.size(); ++i) {
      const double angle = step.scans.front().angle_min + static_cast<double>(i) * step.scans.front().angle_increment;
      const double range =
          static_cast<double>(step.scans.front().ranges[i]) + 1e-4;  // the surface of a cell, and a little more
      if (std::isfinite(range)) {
        const Cell cell =
            map.geometry().cellAt(T_map_lidar * Eigen::Vector2d(range * std::cos(angle), range * std::sin(angle)));
        ASSERT_TRUE(isOccupiedWithin(map, cell, 1)) << "ray " << i << " at " << step.time << " s";
      }
    }
  }
}

TEST(Drive, withNoiseDriftsByAFewPercent) {
  const OccupancyGrid map = building(3);
  double square = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    DriveOptions options = shortDrive(seed);
    options.lidar.beams = 2;
    const Drive drive = simulateDrive(map, options);
    const Rigid2 truth = drive.steps.front().T_map_base.inverse() * drive.steps.back().T_map_base;
    const double error = (truth.translation() - drive.steps.back().T_odom_base.translation()).norm();
    square += std::pow(error / distanceDriven(drive), 2) / 20.0;
  }
  EXPECT_GT(std::sqrt(square), 0.005);
  EXPECT_LT(std::sqrt(square), 0.08);
}

/// Two rooms of 3 m x 3 m with a door of 1 m, half a metre a drawn cell, in cells of 5 cm.
OccupancyGrid twoRooms() {
  return resample(asciiMap({"###############",  //
                            "#......#......#",  //
                            "#......#......#",  //
                            "#.............#",  //
                            "#.............#",  //
                            "#......#......#",  //
                            "#......#......#",  //
                            "###############"},
                           0.5),
                  0.05);
}

TEST(Drive, visitsTheGivenWaypointsInTheirOrderAndEnds) {
  DriveOptions options = shortDrive(1);
  options.start = Rigid2{1.5, 1.5, 2.0};
  options.waypoints = {{6.5, 2.5}, {2.5, 2.8}};
  options.duration = 200.0;
  const OccupancyGrid map = twoRooms();
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

/// From the robot's rim to the nearest leg of the whole drive [m].
double smallestGap(const Drive& drive, double robot_radius) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const DriveStep& step : drive.steps) {
    for (const Person& person : step.people) {
      for (const Circle& leg : person.legs) {
        const double distance = (leg.centre - step.T_map_base.translation()).norm();
        smallest = std::min(smallest, distance - leg.radius - robot_radius);
      }
    }
  }
  return smallest;
}

class CrowdedDrives : public testing::TestWithParam<double> {};

TEST_P(CrowdedDrives, touchNeitherWallsNorPeople) {
  const OccupancyGrid map = building(3);
  DriveOptions options = shortDrive(3);
  options.duration = GetParam() < 1.0 ? 60.0 : 15.0;
  options.pedestrians.density = GetParam();
  const Drive drive = simulateDrive(map, options);
  EXPECT_GT(smallestGap(drive, options.robot.radius), 0.099);
  expectNoCollision(map, drive, options.robot.radius);
  std::cout << GetParam() << " people per square metre: " << drive.steps.front().people.size() << " people, "
            << distanceDriven(drive) << " m in " << options.duration << " s\n";
  for (std::size_t i = 1; i < drive.steps.size(); ++i) {
    const double change = drive.steps[i].velocity.linear - drive.steps[i - 1].velocity.linear;
    ASSERT_LE(std::abs(change), options.robot.max_acceleration / options.rate + 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Densities, CrowdedDrives, testing::Values(0.1, 0.3, 1.0, 3.0));

TEST(Drive, waitsForSomebodyWhoBlocksTheWay) {
  DriveOptions options = shortDrive(1);
  options.start = Rigid2{1.5, 2.0, 0.0};
  options.waypoints = {{6.0, 2.0}};
  options.duration = 60.0;
  options.pedestrians.people = 6;
  const OccupancyGrid map = twoRooms();
  const Drive alone = [&] {
    DriveOptions without = options;
    without.pedestrians.people = 0;
    return simulateDrive(map, without);
  }();
  const Drive drive = simulateDrive(map, options);
  EXPECT_GT(smallestGap(drive, options.robot.radius), 0.099);
  EXPECT_EQ(drive.steps.front().people.size(), 6U);
  EXPECT_GE(drive.steps.size(), alone.steps.size());
}

TEST(Drive, amongPeopleIsTheSameForTheSameSeed) {
  const OccupancyGrid map = building(2);
  DriveOptions options = shortDrive(5);
  options.duration = 10.0;
  options.pedestrians.density = 0.5;
  const Drive one = simulateDrive(map, options);
  const Drive other = simulateDrive(map, options);
  ASSERT_EQ(one.steps.size(), other.steps.size());
  for (std::size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_EQ(one.steps[i].scans.front().ranges, other.steps[i].scans.front().ranges);
    ASSERT_EQ(one.steps[i].people.size(), other.steps[i].people.size());
    EXPECT_EQ(one.steps[i].people.back().position, other.steps[i].people.back().position);
    const auto& detections = one.steps[i].detections.front()->detections;
    ASSERT_EQ(detections.size(), other.steps[i].detections.front()->detections.size());
    if (!detections.empty()) {
      EXPECT_EQ(detections.front().score, other.steps[i].detections.front()->detections.front().score);
    }
  }
}

TEST(Drive, withoutPeopleHasNoDetections) {
  DriveOptions options = shortDrive(5);
  options.duration = 1.0;
  const Drive drive = simulateDrive(building(2), options);
  EXPECT_FALSE(drive.has_people);
  EXPECT_TRUE(drive.steps.front().people.empty());
  EXPECT_TRUE(drive.steps.front().detections.empty());
}

TEST(Drive, ofAPepperLooksBothWays) {
  DriveOptions options = shortDrive(1);
  equipAsPepper(options);
  options.start = Rigid2{1.5, 2.0, 0.0};
  options.duration = 1.0;
  options.lidar.sigma = 0.0;
  options.pedestrians.people = 2;
  const Drive drive = simulateDrive(twoRooms(), options);
  ASSERT_EQ(drive.T_base_lidar.size(), 2U);
  EXPECT_EQ(drive.T_base_lidar[1].x, -0.245);
  const DriveStep& first = drive.steps.front();
  ASSERT_EQ(first.scans.size(), 2U);
  EXPECT_EQ(first.detections.size(), 2U);
  EXPECT_EQ(first.scans[1].ranges.size(), 811U);
  EXPECT_NEAR(first.scans[1].ranges[405], 1.5 - 0.245 - 0.5, 1e-6);  // to the wall behind
}

/// The share of the free cells of the building that a scan passed, within 8 m.
double seenShare(const OccupancyGrid& map, const Drive& drive) {
  const OccupancyGrid coarse = resample(map, 0.1);
  std::vector<bool> seen(coarse.values().size(), false);
  for (const DriveStep& step : drive.steps) {
    const Rigid2 T_map_lidar = step.T_map_base * drive.T_base_lidar.front();
    for (std::size_t i = 0; i < step.scans.front().ranges.size(); ++i) {
      const PlanarScan& scan = step.scans.front();
      const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      for (double r = 0.0; r < std::min<double>(scan.ranges[i], 8.0); r += 0.07) {
        const Cell cell =
            coarse.geometry().cellAt(T_map_lidar * Eigen::Vector2d(r * std::cos(angle), r * std::sin(angle)));
        seen[static_cast<std::size_t>(cell.y * coarse.width() + cell.x)] = true;
      }
    }
  }
  double num_free = 0.0;
  double num_seen = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    num_free += coarse.values()[i] == kFree ? 1.0 : 0.0;
    num_seen += coarse.values()[i] == kFree && seen[i] ? 1.0 : 0.0;
  }
  return num_seen / num_free;
}

TEST(Drive, exploresTheWholeBuildingAndEnds) {
  const OccupancyGrid map = building(1);
  DriveOptions options = shortDrive(1);
  options.duration = 2000.0;
  options.rate = 5.0;
  options.lidar.beams = 271;
  options.explore = true;
  const Drive drive = simulateDrive(map, options);
  std::cout << "explored in " << drive.steps.back().time << " s and " << distanceDriven(drive) << " m\n";
  EXPECT_LT(drive.steps.back().time, 1500.0);
  EXPECT_GT(drive.steps.back().time, 200.0);
  EXPECT_GT(seenShare(map, drive), 0.9);
  EXPECT_LT(longestStay(drive), 15.0);
  expectNoCollision(map, drive, options.robot.radius);
}

TEST(Drive, refusesWaypointsForARobotThatExplores) {
  DriveOptions options = shortDrive(1);
  options.explore = true;
  options.waypoints = {{1.5, 1.5}};
  const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); });
  EXPECT_NE(text.find("waypoints, expected none"), std::string::npos) << text;
}

TEST(Drive, refusesAWaypointThatCannotBeReached) {
  DriveOptions options = shortDrive(1);
  options.start = Rigid2{1.5, 1.5, 0.0};
  options.waypoints = {{2.0, 2.0}, {3.75, 0.75}};
  const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); });
  EXPECT_NE(text.find("waypoint 2 is (3.75, 0.75) m"), std::string::npos) << text;
}

TEST(Drive, refusesAStartWithoutRoomForTheRobot) {
  DriveOptions options = shortDrive(1);
  options.start = Rigid2{0.6, 1.5, 0.0};
  const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); });
  EXPECT_NE(text.find("start is (0.6, 1.5) m, expected a place with 0.25 m of free space"), std::string::npos) << text;
}

TEST(Drive, refusesAMapWithoutFreeSpace) {
  for (const OccupancyGrid& map :
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
  options.start = Rigid2{std::nan(""), 0.0, 0.0};
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
    const OccupancyGrid map = loadMap((*data / "maps" / (std::string(name) + ".yaml")).string());
    DriveOptions options = shortDrive(2);
    options.duration = 120.0;
    const Drive drive = simulateDrive(map, options);
    expectNoCollision(map, drive, options.robot.radius);
    EXPECT_GT(distanceDriven(drive), 30.0);
    EXPECT_LT(longestStay(drive), 10.0);
  }
}

}  // namespace
}  // namespace map_matcher
