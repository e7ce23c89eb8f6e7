// Drives a simulated robot through a map and writes what it measured into a bag.

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/ros/drive_bag.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "map_matcher/simulation/office_building.hpp"

namespace {

using map_matcher::Drive;
using map_matcher::DriveOptions;
using map_matcher::OccupancyGrid;

struct Arguments {
  std::string map;
  std::uint64_t building_seed = 1;
  std::string bag;
  std::vector<double> start;
  std::vector<double> waypoints;
  DriveOptions drive;
};

void describe(CLI::App& app, Arguments& arguments) {
  auto* map = app.add_option("--map", arguments.map, "YAML file of the map to drive in");
  map_matcher::tools::addSeed(app, "--building-seed", arguments.building_seed,
                              "Drive in the floor that generate_building makes of this seed")
      ->excludes(map);
  app.add_option("--bag", arguments.bag, "Bag to write")->required();
  map_matcher::tools::addSeed(app, "--seed", arguments.drive.seed, "Of the way and the noise");
  app.add_option("--start", arguments.start, "Pose x y yaw in the map [m m rad]; random when not given")->expected(3);
  app.add_option("--waypoints", arguments.waypoints,
                 "Places x1 y1 x2 y2 ... in the map to visit in this order [m]; random ones when not given");
  map_matcher::tools::addOptions(app, parametersOf(arguments.drive));
  app.footer("Exit status: 0 written, 2 bad input.\n");
}

DriveOptions readOptions(const Arguments& arguments) {
  DriveOptions options = arguments.drive;
  if (!arguments.start.empty()) {
    options.start = {arguments.start[0], arguments.start[1], arguments.start[2]};
  }
  if (arguments.waypoints.size() % 2 != 0) {
    throw std::invalid_argument("--waypoints has " + std::to_string(arguments.waypoints.size()) +
                                " numbers, expected an x and a y for each place");
  }
  for (std::size_t i = 0; i + 1 < arguments.waypoints.size(); i += 2) {
    options.waypoints.emplace_back(arguments.waypoints[i], arguments.waypoints[i + 1]);
  }
  return options;
}

void printSummary(const Arguments& arguments, const Drive& drive) {
  double length = 0.0;
  for (std::size_t i = 1; i < drive.steps.size(); ++i) {
    length += (drive.steps[i].T_map_base.translation() - drive.steps[i - 1].T_map_base.translation()).norm();
  }
  const map_matcher::Rigid2& start = drive.steps.front().T_map_base;
  std::cout << arguments.bag << ": " << drive.steps.size() << " scans in " << drive.steps.back().time << " s, "
            << length << " m driven from (" << start.x << ", " << start.y << ", " << start.yaw << "), "
            << drive.visited.size() << " waypoints reached\n";
}

void simulate(const Arguments& arguments) {
  map_matcher::OfficeBuildingOptions building;
  building.seed = arguments.building_seed;
  const OccupancyGrid map =
      arguments.map.empty() ? map_matcher::officeBuilding(building) : map_matcher::loadMap(arguments.map);
  const Drive drive = map_matcher::simulateDrive(map, readOptions(arguments));
  map_matcher::writeDriveBag(drive, arguments.bag);
  printSummary(arguments, drive);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Drives a simulated robot through a map and writes scans, odometry, tf and ground truth into a bag.",
               "simulate_drive");
  Arguments arguments;
  describe(app, arguments);
  return map_matcher::tools::run(app, argc, argv, [&] {
    simulate(arguments);
    return map_matcher::tools::kDone;
  });
}
