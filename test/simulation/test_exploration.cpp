#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/grid/resample.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "support/drives.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using test::building;
using test::distanceDriven;
using test::expectNoCollision;
using test::longestStay;
using test::shortDrive;
using test::thrownText;
using test::twoRooms;

/// The share of the free cells of the building that a scan passed, within 8 m.
double seenShare(const grid::OccupancyGrid& map, const Drive& drive) {
  const grid::OccupancyGrid coarse = grid::resample(map, 0.1);
  std::vector<bool> seen(coarse.values().size(), false);
  for (const DriveStep& step : drive.steps) {
    const grid::Rigid2 T_map_lidar = step.T_map_base * drive.T_base_lidar.front();
    for (std::size_t i = 0; i < step.scans.front().ranges.size(); ++i) {
      const scan::PlanarScan& scan = step.scans.front();
      const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      for (double r = 0.0; r < std::min<double>(scan.ranges[i], 8.0); r += 0.07) {
        const grid::Cell cell =
            coarse.geometry().cellAt(T_map_lidar * Eigen::Vector2d(r * std::cos(angle), r * std::sin(angle)));
        seen[static_cast<std::size_t>(cell.y * coarse.width() + cell.x)] = true;
      }
    }
  }
  double num_free = 0.0;
  double num_seen = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    num_free += coarse.values()[i] == grid::kFree ? 1.0 : 0.0;
    num_seen += coarse.values()[i] == grid::kFree && seen[i] ? 1.0 : 0.0;
  }
  return num_seen / num_free;
}

TEST(Exploration, seesTheWholeBuildingAndEnds) {
  const grid::OccupancyGrid map = building(1);
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

TEST(Exploration, refusesWaypointsForARobotThatExplores) {
  DriveOptions options = shortDrive(1);
  options.explore = true;
  options.waypoints = {{1.5, 1.5}};
  const std::string text = thrownText<std::invalid_argument>([&] { simulateDrive(twoRooms(), options); });
  EXPECT_NE(text.find("waypoints, expected none"), std::string::npos) << text;
}

}  // namespace
}  // namespace map_matcher::simulation
