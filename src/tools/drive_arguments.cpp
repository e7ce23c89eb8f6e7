#include "drive_arguments.hpp"

#include <stdexcept>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/simulation/office_building.hpp"

namespace map_matcher::tools {

simulation::Rectangle rectangleOf(const std::string& option, const std::vector<double>& values) {
  const simulation::Rectangle rectangle{values.at(0), values.at(1), values.at(2), values.at(3)};
  if (rectangle.width() <= 0.0 || rectangle.height() <= 0.0) {
    throw std::invalid_argument(option +
                                " is empty, expected x_min y_min x_max y_max with x_min < x_max, y_min < y_max");
  }
  return rectangle;
}

DriveArguments::DriveArguments(int argc, char** argv) {
  if (firstValueOf("--robot", argc, argv) == "pepper") {
    simulation::equipAsPepper(drive_);
  }
}

void DriveArguments::describe(CommandLine& command_line) {
  const Option& map = command_line.add("--map", &map_, "YAML file of the map to drive in");
  command_line.add("--building-seed", &building_seed_, "Drive in the floor that generate_building makes of this seed")
      .excludes(map);
  command_line.add("--seed", &drive_.seed, "Of the way and the noise");
  command_line
      .add("--robot", &robot_,
           "pioneer: one lidar, /scan; pepper: two, /sick_laser_front/scan and /sick_laser_rear/scan, and another size "
           "and speed")
      .choices({"pioneer", "pepper"});
  command_line
      .add("--itinerary", &itinerary_,
           "waypoints: those given; random: random ones for ever; explore: wherever nothing was seen yet, until all "
           "is; when not given: waypoints, if there are any, else random")
      .choices({"waypoints", "random", "explore"});
  const Option& start =
      command_line.add("--start", &start_, "Pose x y yaw in the map [m m rad]; random when not given").count(3);
  command_line
      .add("--area", &area_,
           "Where random starts and waypoints lie: x_min y_min x_max y_max in the map [m]; anywhere when not given")
      .count(4)
      .excludes(start);
  command_line.add("--waypoints", &waypoints_,
                   "Places x1 y1 x2 y2 ... in the map to visit in this order [m]; random ones when not given");
  command_line.addParameters(parametersOf(drive_));
}

grid::OccupancyGrid DriveArguments::map() const {
  simulation::OfficeBuildingOptions building;
  building.seed = building_seed_;
  return map_.empty() ? simulation::officeBuilding(building) : grid::loadMap(map_);
}

simulation::DriveOptions DriveArguments::options() const {
  simulation::DriveOptions options = drive_;
  if (!start_.empty()) {
    options.start = {start_[0], start_[1], start_[2]};
  }
  if (!area_.empty()) {
    options.area = rectangleOf("--area", area_);
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
