#include "map_matcher/ros/simulation/crowd_simulator_server_options.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/simulation/office_building.hpp"

namespace map_matcher::ros_simulation {
namespace {

constexpr double kDensity = 0.3;      // [1/m^2]
constexpr double kDuration = 3600.0;  // [s]

/// The numbers of a text between spaces or commas; throws with `name` and what was `expected` for anything else.
std::vector<double> numbersOf(const std::string& text, const std::string& name, const std::string& expected) {
  std::string spaced = text;
  for (char& c : spaced) {
    c = c == ',' ? ' ' : c;
  }
  std::istringstream in(spaced);
  in.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number = 0.0; in >> number;) {
    numbers.push_back(number);
  }
  if (!in.eof()) {
    throw std::invalid_argument("~" + name + " is \"" + text + "\", expected " + expected);
  }
  return numbers;
}

}  // namespace

CrowdSimulatorServerOptions::CrowdSimulatorServerOptions() {
  drive.duration = kDuration;
  drive.pedestrians.density = kDensity;
}

parameters::ParameterList parametersOf(CrowdSimulatorServerOptions& options) {
  constexpr double kLargestSeed = std::numeric_limits<int>::max();
  parameters::ParameterList parameters{
      {"map_file", "", "YAML file of the map to drive in; empty: the building of building_seed.", &options.map_file},
      {"building_seed", "", "Which floor generate_building makes.", &options.building_seed, 0, kLargestSeed},
      {"building_resolution", "m", "Edge length of a cell of that floor's map.", &options.building_resolution, 0.01,
       0.1},
      {"seed", "", "Of the way, the noise, the people and the detectors.", &options.seed, 0, kLargestSeed},
      {"itinerary",
       "",
       "Where the robot goes: to random places for ever, or wherever it saw nothing yet.",
       &options.itinerary,
       {},
       {},
       {"random", "explore"}},
      {"start", "", "First pose of the robot in the map, \"x y yaw\" in m, m and rad; empty: a random one.",
       &options.start},
      {"waypoints", "", "Places to visit instead, \"x1 y1 x2 y2\" and so on in m; the drive ends at the last.",
       &options.waypoints},
      {"rear_lidar", "", "Whether a second lidar looks back, where the first would be on a robot turned round.",
       &options.rear_lidar},
      {"real_time_factor", "", "How many times as fast as real time simulated time passes; 0: as fast as possible.",
       &options.real_time_factor, 0.0, 1000.0},
      {"start_delay", "s", "Real time for other nodes to listen before the drive begins.", &options.start_delay, 0.0,
       60.0},
      {"map_frame", "", "tf frame of the map that is driven in.", &options.map_frame},
      {"odom_frame", "", "tf frame of the odometry, the parent of base_frame.", &options.odom_frame},
      {"base_frame", "", "tf frame of the robot.", &options.base_frame},
  };
  const parameters::ParameterList drive = parametersOf(options.drive);
  parameters.insert(parameters.end(), drive.begin(), drive.end());
  return parameters;
}

simulation::DriveOptions driveOf(const CrowdSimulatorServerOptions& options) {
  simulation::DriveOptions drive = options.drive;
  drive.seed = static_cast<std::uint64_t>(options.seed);
  drive.explore = options.itinerary == "explore";
  if (options.rear_lidar) {
    drive.more_lidars.push_back(grid::Rigid2{0.0, 0.0, M_PI} * drive.lidar.T_base_lidar);
  }
  if (!options.start.empty()) {
    const char* expected = "three numbers, x y yaw [m m rad]";
    const std::vector<double> pose = numbersOf(options.start, "start", expected);
    if (pose.size() != 3) {
      throw std::invalid_argument("~start is \"" + options.start + "\", expected " + expected);
    }
    drive.start = {pose[0], pose[1], pose[2]};
  }
  const char* expected = "an x and a y for each place [m]";
  const std::vector<double> places = numbersOf(options.waypoints, "waypoints", expected);
  if (places.size() % 2 != 0) {
    throw std::invalid_argument("~waypoints has " + std::to_string(places.size()) + " numbers, expected " + expected);
  }
  for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
    drive.waypoints.emplace_back(places[i], places[i + 1]);
  }
  return drive;
}

grid::OccupancyGrid mapOf(const CrowdSimulatorServerOptions& options) {
  simulation::OfficeBuildingOptions building;
  building.seed = static_cast<std::uint64_t>(options.building_seed);
  building.resolution = options.building_resolution;
  return options.map_file.empty() ? simulation::officeBuilding(building) : grid::loadMap(options.map_file);
}

}  // namespace map_matcher::ros_simulation
