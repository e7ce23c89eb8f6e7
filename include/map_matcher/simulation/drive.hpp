/// \file
/// A simulated drive: what a robot would have recorded on its way through a building.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/simulation/itinerary.hpp"
#include "map_matcher/simulation/lidar.hpp"
#include "map_matcher/simulation/path_follower.hpp"
#include "map_matcher/simulation/pedestrians.hpp"
#include "map_matcher/simulation/person_detector.hpp"
#include "map_matcher/simulation/rectangle.hpp"
#include "map_matcher/simulation/robot.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// What a drive is like. Ranges stand in parametersOf().
struct DriveOptions {
  std::uint64_t seed = 1;   ///< Of the way, the noise, the people and the detectors, each in a stream of its own.
  double duration = 120.0;  ///< [s] A drive along given waypoints may end sooner.
  double rate = 15.0;       ///< [Hz] Scans and odometry readings.
  double min_waypoint_distance = 8.0;  ///< [m] Straight distance of a random waypoint from the last, where possible.
  double patience = 10.0;              ///< [s] A robot that people hold up so long goes to another random waypoint.
  std::optional<grid::Rigid2> start;   ///< Pose in the map frame; random when there is none.
  std::optional<Rectangle> area;       ///< Where random starts and waypoints lie [m, map frame]; none: anywhere.
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In the map frame, visited in this order; none: random ones for ever.
  bool explore = false;  ///< Goes to frontiers of what its lidars saw until all is seen; without waypoints.
  LidarOptions lidar;    ///< Of every lidar; T_base_lidar is where the first is mounted.
  std::vector<grid::Rigid2> more_lidars;  ///< T_base_lidar of further ones; each has noise of its own.
  RobotOptions robot;
  OdometryOptions odometry;
  PedestrianOptions pedestrians;   ///< By default there are none.
  PersonDetectorOptions detector;  ///< Where there are people, every lidar has one.
};

/// The parameters that fill `options`, with those of its parts.
parameters::ParameterList parametersOf(DriveOptions& options);

/// Two SICK TiM571 look ahead and back from a robot of the size and speed of the CROWDBOT Pepper. Other options remain.
void equipAsPepper(DriveOptions& options);

/// What is known at one instant.
struct DriveStep {
  double time = 0.0;                    ///< Since the start of the drive [s].
  grid::Rigid2 T_map_base;              ///< Where the robot is.
  grid::Rigid2 T_odom_base;             ///< Where its odometry believes it to be; the odom frame is its first pose.
  Velocity velocity;                    ///< Of the base.
  std::vector<scan::PlanarScan> scans;  ///< Of each lidar.
  std::vector<Person> people;           ///< Everybody, seen or not, always in the same order.
  std::vector<std::optional<DetectedPeople>> detections;  ///< Of each lidar's detector; std::nullopt: it was busy.
};

/// A drive from its start to its end.
struct Drive {
  std::vector<grid::Rigid2> T_base_lidar;  ///< Mounting pose of each lidar.
  std::vector<DriveStep> steps;            ///< Equally spaced in time, the first at 0 with the robot at rest.
  std::vector<Eigen::Vector2d> visited;    ///< Waypoints that were reached, in their order [m].
  bool has_people = false;                 ///< Whether people were asked for, so that there are detections.
};

/// A robot that drives through the free space of a map, among people who walk and stand there. It waits before people
/// and never touches one. The same map and options give the same drive. Neither copied nor moved; not thread-safe.
class DriveSimulation {
 public:
  /// Throws std::invalid_argument that names every option out of its range, a map without room for the robot, a start
  /// or waypoint that the robot does not fit in or cannot reach, an area without room for it.
  DriveSimulation(const grid::OccupancyGrid& map, const DriveOptions& options);
  DriveSimulation(const DriveSimulation&) = delete;
  DriveSimulation& operator=(const DriveSimulation&) = delete;

  /// Drives on; std::nullopt when the drive is over: after its duration, its last waypoint, or when all is explored.
  std::optional<DriveStep> next();

  /// Mounting pose of each lidar.
  const std::vector<grid::Rigid2>& lidarPoses() const { return T_base_lidar_; }

  /// Waypoints that were reached, in their order [m].
  const std::vector<Eigen::Vector2d>& visited() const { return visited_; }

  /// Whether people were asked for.
  bool hasPeople() const { return people_.has_value(); }

 private:
  void equip(const grid::OccupancyGrid& map);
  void drive(double period);
  void follow(double period, int num_commands);
  void lookForOtherWay(double period);
  void explore(const DriveStep& step);
  RobotSweep sweep(double command_period) const;
  std::vector<Mover> moversNear() const;
  std::vector<Circle> bodiesNear() const;
  DriveStep look();

  DriveOptions options_;
  World world_;
  Itinerary itinerary_;
  DifferentialDrive robot_;
  Odometry odometry_;
  std::vector<grid::Rigid2> T_base_lidar_;
  std::vector<Lidar> lidars_;
  std::vector<PersonDetector> detectors_;
  std::optional<Pedestrians> people_;
  std::optional<Path> way_;
  std::optional<PathFollower> follower_;
  std::vector<Eigen::Vector2d> visited_;
  bool is_over_ = false;        // everything was explored
  std::size_t num_steps_ = 0;   // that were taken
  Eigen::Vector2d lingers_at_;  // where the robot was when it last got on
  double lingers_for_ = 0.0;    // [s]
};

/// The whole of such a drive at once, all its scans in memory; throws as DriveSimulation does.
Drive simulateDrive(const grid::OccupancyGrid& map, const DriveOptions& options);

}  // namespace map_matcher::simulation
