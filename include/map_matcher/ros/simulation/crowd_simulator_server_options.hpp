/// \file
/// What can be chosen about the crowd_simulator node.
#pragma once

#include <string>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/simulation/drive.hpp"

namespace map_matcher::ros_simulation {

/// Options of the crowd_simulator node. Those of the drive itself differ from DriveOptions in that there are people
/// (0.3 per square metre) and in that it takes an hour.
struct CrowdSimulatorServerOptions {
  CrowdSimulatorServerOptions();

  std::string map_file;                  ///< YAML file of the map to drive in; empty: the building of building_seed.
  int building_seed = 1;                 ///< As generate_building takes it.
  double building_resolution = 0.05;     ///< [m] Edge length of a cell of that building's map.
  int seed = 1;                          ///< Becomes drive.seed.
  std::string itinerary = "random";      ///< random or explore: where a robot without waypoints goes.
  std::string start;                     ///< "x y yaw" in the map frame [m m rad]; empty: random.
  std::string waypoints;                 ///< "x1 y1 x2 y2 ..." in the map frame [m]; empty: by itinerary.
  bool rear_lidar = false;               ///< A second lidar where the first would be on a robot turned round.
  double real_time_factor = 1.0;         ///< Simulated time passes so many times as fast as real time; 0: no waiting.
  double start_delay = 2.0;              ///< [s] of real time for other nodes to listen before the drive begins.
  std::string map_frame = "map";         ///< tf frame of the map that is driven in.
  std::string odom_frame = "odom";       ///< tf frame of the odometry, the parent of base_frame.
  std::string base_frame = "base_link";  ///< tf frame of the robot.
  simulation::DriveOptions drive;        ///< seed, explore, start, waypoints and more_lidars are set by driveOf().
};

/// The parameters of config/crowd_simulator.yaml.
parameters::ParameterList parametersOf(CrowdSimulatorServerOptions& options);

/// The drive that is asked for. Throws std::invalid_argument, with the name and value of the option, for texts that are
/// not the numbers expected.
simulation::DriveOptions driveOf(const CrowdSimulatorServerOptions& options);

/// The map to drive in. Throws as loadMap() does.
grid::OccupancyGrid mapOf(const CrowdSimulatorServerOptions& options);

}  // namespace map_matcher::ros_simulation
