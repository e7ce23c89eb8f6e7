// Drives a simulated robot through a map and writes what it measured into a bag.

#include <CLI/CLI.hpp>
#include <cstddef>
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

using map_matcher::DriveOptions;
using map_matcher::DriveSimulation;
using map_matcher::DriveStep;
using map_matcher::OccupancyGrid;

struct Arguments {
  std::string map;
  std::uint64_t building_seed = 1;
  std::string bag;
  std::string robot = "pioneer";
  std::string itinerary;
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
  app.add_option(
         "--robot", arguments.robot,
         "pioneer: one lidar, /scan; pepper: two, /sick_laser_front/scan and /sick_laser_rear/scan, and another "
         "size and speed")
      ->capture_default_str()
      ->check(CLI::IsMember({"pioneer", "pepper"}));
  app.add_option(
         "--itinerary", arguments.itinerary,
         "waypoints: those given; random: random ones for ever; explore: wherever nothing was seen yet, until all "
         "is; when not given: waypoints, if there are any, else random")
      ->check(CLI::IsMember({"waypoints", "random", "explore"}));
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
  if (!arguments.itinerary.empty() && (arguments.itinerary == "waypoints") == arguments.waypoints.empty()) {
    throw std::invalid_argument("--itinerary is " + arguments.itinerary + ", expected " +
                                (arguments.waypoints.empty() ? "--waypoints with it" : "no --waypoints with it"));
  }
  options.explore = arguments.itinerary == "explore";
  if (arguments.waypoints.size() % 2 != 0) {
    throw std::invalid_argument("--waypoints has " + std::to_string(arguments.waypoints.size()) +
                                " numbers, expected an x and a y for each place");
  }
  for (std::size_t i = 0; i + 1 < arguments.waypoints.size(); i += 2) {
    options.waypoints.emplace_back(arguments.waypoints[i], arguments.waypoints[i + 1]);
  }
  return options;
}

/// What was driven.
class Summary {
 public:
  void add(const DriveStep& step) {
    if (num_steps_ == 0) {
      start_ = step.T_map_base;
      num_people_ = step.people.size();
    } else {
      length_ += (step.T_map_base.translation() - last_.T_map_base.translation()).norm();
    }
    ++num_steps_;
    last_.T_map_base = step.T_map_base;
    last_.time = step.time;
  }

  void print(const std::string& bag, const DriveSimulation& simulation) const {
    std::cout << bag << ": " << num_steps_ * simulation.lidarPoses().size() << " scans in " << last_.time << " s, "
              << length_ << " m driven from (" << start_.x << ", " << start_.y << ", " << start_.yaw << "), "
              << simulation.visited().size() << " waypoints reached";
    if (simulation.hasPeople()) {
      std::cout << ", " << num_people_ << " people";
    }
    std::cout << '\n';
  }

 private:
  std::size_t num_steps_ = 0;
  std::size_t num_people_ = 0;
  double length_ = 0.0;  // [m]
  map_matcher::Rigid2 start_;
  DriveStep last_;
};

void simulate(const Arguments& arguments) {
  map_matcher::OfficeBuildingOptions building;
  building.seed = arguments.building_seed;
  const OccupancyGrid map =
      arguments.map.empty() ? map_matcher::officeBuilding(building) : map_matcher::loadMap(arguments.map);
  const DriveOptions options = readOptions(arguments);
  DriveSimulation simulation(map, options);
  map_matcher::DriveBagOptions bag_options;
  bag_options.score_threshold = options.detector.score_threshold;
  map_matcher::DriveBagWriter bag(arguments.bag, {simulation.lidarPoses(), 1.0 / options.rate}, bag_options);
  Summary summary;
  while (const auto step = simulation.next()) {
    bag.write(*step);
    summary.add(*step);
  }
  bag.close();
  summary.print(arguments.bag, simulation);
}

/// The robot that the arguments name: its options are defaults for theirs, so it has to be known before they are read.
std::string robotIn(int argc, char** argv) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::string robot;
  app.add_option("--robot", robot);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError&) {
    return "";  // will be told when all arguments are read
  }
  return robot;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Drives a simulated robot through a map, among people with --people or --density, and writes scans, odometry, "
      "tf, ground truth and detections of people into a bag.",
      "simulate_drive");
  Arguments arguments;
  if (robotIn(argc, argv) == "pepper") {
    equipAsPepper(arguments.drive);
  }
  describe(app, arguments);
  return map_matcher::tools::run(app, argc, argv, [&] {
    simulate(arguments);
    return map_matcher::tools::kDone;
  });
}
