#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "map_matcher/simulation/drive.hpp"
#include "support/drives.hpp"

namespace map_matcher::simulation {
namespace {

using test::building;
using test::distanceDriven;
using test::expectNoCollision;
using test::shortDrive;
using test::twoRooms;

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
  const grid::OccupancyGrid map = building(3);
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

TEST(CrowdedDrive, getsToItsWaypointNoSoonerThanAlone) {
  DriveOptions options = shortDrive(1);
  options.start = grid::Rigid2{1.5, 2.0, 0.0};
  options.waypoints = {{6.0, 2.0}};
  options.duration = 60.0;
  options.pedestrians.people = 6;
  const grid::OccupancyGrid map = twoRooms();
  const Drive alone = [&] {
    DriveOptions without = options;
    without.pedestrians.people = 0;
    return simulateDrive(map, without);
  }();
  const Drive drive = simulateDrive(map, options);
  EXPECT_GT(smallestGap(drive, options.robot.radius), 0.099);
  EXPECT_EQ(drive.steps.front().people.size(), 6U);
  EXPECT_EQ(drive.visited, options.waypoints);
  EXPECT_GE(drive.steps.size(), alone.steps.size());
}

TEST(CrowdedDrive, amongPeopleIsTheSameForTheSameSeed) {
  const grid::OccupancyGrid map = building(2);
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
    const auto& detections = one.steps[i].detections.front()->people;
    ASSERT_EQ(detections.size(), other.steps[i].detections.front()->people.size());
    if (!detections.empty()) {
      EXPECT_EQ(detections.front().score, other.steps[i].detections.front()->people.front().score);
    }
  }
}

TEST(CrowdedDrive, withoutPeopleHasNoDetections) {
  DriveOptions options = shortDrive(5);
  options.duration = 1.0;
  const Drive drive = simulateDrive(building(2), options);
  EXPECT_FALSE(drive.has_people);
  EXPECT_TRUE(drive.steps.front().people.empty());
  EXPECT_TRUE(drive.steps.front().detections.empty());
}

TEST(CrowdedDrive, ofAPepperLooksBothWays) {
  DriveOptions options = shortDrive(1);
  equipAsPepper(options);
  options.start = grid::Rigid2{1.5, 2.0, 0.0};
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

}  // namespace
}  // namespace map_matcher::simulation
