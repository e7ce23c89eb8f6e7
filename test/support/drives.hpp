/// \file
/// Places to drive in, and what is to be found out about a drive.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "map_matcher/grid/resample.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::test {

/// The office floor of a seed.
inline grid::OccupancyGrid building(std::uint64_t seed) {
  simulation::OfficeBuildingOptions options;
  options.seed = seed;
  return simulation::officeBuilding(options);
}

/// 30 s with few rays.
inline simulation::DriveOptions shortDrive(std::uint64_t seed) {
  simulation::DriveOptions options;
  options.seed = seed;
  options.duration = 30.0;
  options.lidar.beams = 91;
  return options;
}

/// The length of the robot's way [m].
inline double distanceDriven(const simulation::Drive& drive) {
  double distance = 0.0;
  for (std::size_t i = 1; i < drive.steps.size(); ++i) {
    distance += (drive.steps[i].T_map_base.translation() - drive.steps[i - 1].T_map_base.translation()).norm();
  }
  return distance;
}

/// Whether a circle touches a cell that is not free, by looking at every cell near it.
inline bool touchesSomething(const grid::OccupancyGrid& grid, const Eigen::Vector2d& p_map, double radius) {
  const grid::GridGeometry& geometry = grid.geometry();
  const Eigen::Vector2d p = geometry.T_map_grid.inverse() * p_map / geometry.resolution;
  const double r = radius / geometry.resolution;
  for (int y = static_cast<int>(std::floor(p.y() - r)); y <= static_cast<int>(std::floor(p.y() + r)); ++y) {
    for (int x = static_cast<int>(std::floor(p.x() - r)); x <= static_cast<int>(std::floor(p.x() + r)); ++x) {
      const double dx = std::max({x - p.x(), 0.0, p.x() - (x + 1)});
      const double dy = std::max({y - p.y(), 0.0, p.y() - (y + 1)});
      const bool is_free =
          geometry.contains({x, y}) && grid.at(x, y) >= grid::kFree && grid.at(x, y) < grid::kDefaultOccupiedThreshold;
      if (!is_free && std::hypot(dx, dy) < r) {
        return true;
      }
    }
  }
  return false;
}

/// Whether the robot kept its radius [m] to whatever is not free.
inline void expectNoCollision(const grid::OccupancyGrid& map, const simulation::Drive& drive, double radius) {
  for (const simulation::DriveStep& step : drive.steps) {
    ASSERT_FALSE(touchesSomething(map, step.T_map_base.translation(), radius))
        << "at " << step.time << " s in (" << step.T_map_base.x << ", " << step.T_map_base.y << ")";
  }
}

/// The longest time that the robot stays within 0.3 m [s].
inline double longestStay(const simulation::Drive& drive) {
  double longest = 0.0;
  const simulation::DriveStep* here = &drive.steps.front();
  for (const simulation::DriveStep& step : drive.steps) {
    if ((step.T_map_base.translation() - here->T_map_base.translation()).norm() > 0.3) {
      here = &step;
    }
    longest = std::max(longest, step.time - here->time);
  }
  return longest;
}

/// Two rooms of 3 m x 3 m with a door of 1 m, half a metre a drawn cell, in cells of 5 cm.
inline grid::OccupancyGrid twoRooms() {
  return grid::resample(asciiMap({"###############",  //
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

}  // namespace map_matcher::test
