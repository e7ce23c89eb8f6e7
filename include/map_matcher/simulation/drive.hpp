/// \file
/// A simulated drive: what a robot would have recorded on its way through a building.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/simulation/lidar.hpp"
#include "map_matcher/simulation/robot.hpp"

namespace map_matcher {

/// What a drive is like. Ranges stand in parametersOf().
struct DriveOptions {
  std::uint64_t seed = 1;   ///< Of the way, the lidar's noise and the odometry's, each in a stream of its own.
  double duration = 120.0;  ///< [s] A drive along given waypoints may end sooner.
  double rate = 15.0;       ///< [Hz] Scans and odometry readings.
  double min_waypoint_distance = 8.0;  ///< [m] Straight distance of a random waypoint from the last, where possible.
  std::optional<Rigid2> start;         ///< Pose in the map frame; random when there is none.
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In the map frame, visited in this order; none: random ones for ever.
  LidarOptions lidar;
  RobotOptions robot;
  OdometryOptions odometry;
};

/// The parameters that fill `options`, with those of its parts.
ParameterList parametersOf(DriveOptions& options);

/// What is known at one instant.
struct DriveStep {
  double time = 0.0;   ///< Since the start of the drive [s].
  Rigid2 T_map_base;   ///< Where the robot is.
  Rigid2 T_odom_base;  ///< Where its odometry believes it to be; the odom frame is its first pose.
  Velocity velocity;   ///< Of the base.
  LidarScan scan;
};

/// A drive from its start to its end.
struct Drive {
  Rigid2 T_base_lidar;                   ///< Mounting pose of the lidar.
  std::vector<DriveStep> steps;          ///< Equally spaced in time, the first at 0 with the robot at rest.
  std::vector<Eigen::Vector2d> visited;  ///< Waypoints that were reached, in their order [m].
};

/// Drives through the free space of `map` and records. The same map and options give the same drive. Throws
/// std::invalid_argument that names every option out of its range, a map without room for the robot, a start or
/// waypoint that the robot does not fit in or cannot reach.
Drive simulateDrive(const OccupancyGrid& map, const DriveOptions& options);

}  // namespace map_matcher
