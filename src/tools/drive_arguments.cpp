#include "drive_arguments.hpp"

#include <stdexcept>

#include "command_line.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/simulation/office_building.hpp"

namespace map_matcher::tools {
namespace {

/// The robot that the arguments name; "" when they cannot be read, which will be told when all of them are.
std::string robotIn(int argc, char** argv) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::string robot;
  app.add_option("--robot", robot);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError&) {
    return "";
  }
  return robot;
}

}  // namespace

DriveArguments::DriveArguments(int argc, char** argv) {
  if (robotIn(argc, argv) == "pepper") {
    equipAsPepper(drive_);
  }
}

void DriveArguments::describe(CLI::App& app) {
  auto* map = app.add_option("--map", map_, "YAML file of the map to drive in");
  addSeed(app, "--building-seed", building_seed_, "Drive in the floor that generate_building makes of this seed")
      ->excludes(map);
  addSeed(app, "--seed", drive_.seed, "Of the way and the noise");
  app.add_option(
         "--robot", robot_,
         "pioneer: one lidar, /scan; pepper: two, /sick_laser_front/scan and /sick_laser_rear/scan, and another "
         "size and speed")
      ->capture_default_str()
      ->check(CLI::IsMember({"pioneer", "pepper"}));
  app.add_option(
         "--itinerary", itinerary_,
         "waypoints: those given; random: random ones for ever; explore: wherever nothing was seen yet, until all "
         "is; when not given: waypoints, if there are any, else random")
      ->check(CLI::IsMember({"waypoints", "random", "explore"}));
  app.add_option("--start", start_, "Pose x y yaw in the map [m m rad]; random when not given")->expected(3);
  app.add_option("--waypoints", waypoints_,
                 "Places x1 y1 x2 y2 ... in the map to visit in this order [m]; random ones when not given");
  addOptions(app, parametersOf(drive_));
}

OccupancyGrid DriveArguments::map() const {
  OfficeBuildingOptions building;
  building.seed = building_seed_;
  return map_.empty() ? officeBuilding(building) : loadMap(map_);
}

DriveOptions DriveArguments::options() const {
  DriveOptions options = drive_;
  if (!start_.empty()) {
    options.start = {start_[0], start_[1], start_[2]};
  }
  if (!itinerary_.empty() && (itinerary_ == "waypoints") == waypoints_.empty()) {
    throw std::invalid_argument("--itinerary is " + itinerary_ + ", expected " +
                                (waypoints_.empty() ? "--waypoints with it" : "no --waypoints with it"));
  }
  options.explore = itinerary_ == "explore";
  if (waypoints_.size() % 2 != 0) {
    throw std::invalid_argument("--waypoints has " + std::to_string(waypoints_.size()) +
                                " numbers, expected an x and a y for each place");
  }
  for (std::size_t i = 0; i + 1 < waypoints_.size(); i += 2) {
    options.waypoints.emplace_back(waypoints_[i], waypoints_[i + 1]);
  }
  return options;
}

}  // namespace map_matcher::tools
