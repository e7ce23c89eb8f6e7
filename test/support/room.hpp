/// \file
/// A room whose walls are known exactly, and the scans of a laser in it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>

#include "map_matcher/scan/planar_scan.hpp"

namespace map_matcher::test {

/// A rectangular room without furniture, its walls at these coordinates of the world [m].
struct Room {
  double left = -3.0;
  double right = 4.02;
  double lower = -2.0;
  double upper = 2.52;
};

constexpr int kNumBeams = 360;

/// Range from a point in the room to its walls.
inline double rangeIn(const Room& room, const Eigen::Vector2d& from, double direction) {
  const double dx = std::cos(direction);
  const double dy = std::sin(direction);
  const double along_x = dx == 0.0 ? 1e9 : ((dx > 0.0 ? room.right : room.left) - from.x()) / dx;
  const double along_y = dy == 0.0 ? 1e9 : ((dy > 0.0 ? room.upper : room.lower) - from.y()) / dy;
  return std::min(along_x, along_y);
}

/// A 270 degree scan of the room; the beams of a laser upside down turn clockwise.
inline scan::PlanarScan scanFrom(const Room& room, const grid::Rigid2& T_world_base,
                                 const scan::LaserMount& mount = {}) {
  scan::PlanarScan scan{-0.75 * M_PI, 1.5 * M_PI / (kNumBeams - 1), 0.05, 20.0, {}};
  const grid::Rigid2 laser = T_world_base * mount.T_base_laser;
  for (int i = 0; i < kNumBeams; ++i) {
    const double angle = scan.angle_min + i * scan.angle_increment;
    const double direction = laser.yaw + (mount.upside_down ? -angle : angle);
    scan.ranges.push_back(static_cast<float>(rangeIn(room, laser.translation(), direction)));
  }
  return scan;
}

/// Distance of a point to the nearest wall of the room.
inline double distanceToWall(const Room& room, const Eigen::Vector2d& p) {
  return std::min({std::abs(p.x() - room.left), std::abs(p.x() - room.right), std::abs(p.y() - room.lower),
                   std::abs(p.y() - room.upper)});
}

/// The scan with normal noise of each range [m].
inline scan::PlanarScan noisy(scan::PlanarScan scan, double sigma, std::mt19937& generator) {
  std::normal_distribution<double> noise(0.0, sigma);
  for (float& range : scan.ranges) {
    range += static_cast<float>(noise(generator));
  }
  return scan;
}

}  // namespace map_matcher::test
