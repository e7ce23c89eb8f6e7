// Writes the map of a generated office floor.

#include <iostream>
#include <string>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/simulation/office_building.hpp"

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line(
      "generate_building",
      "Generates the map of an office floor: the same seed gives the same floor at every resolution.",
      "Exit status: 0 written, 2 bad input.");
  map_matcher::simulation::OfficeBuildingOptions options;
  std::string output;
  command_line.add("--output", &output, "YAML file to write; a PGM image of the same name is written beside it")
      .required();
  command_line.add("--seed", &options.seed, "Which floor");
  command_line.add("--furniture-seed", &options.furniture_seed, "Which furniture; 0: that of the floor");
  command_line.add("--change-seed", &options.change_seed,
                   "Which furniture was moved, with --moved-furniture, and which doors are shut, with --shut-doors");
  int floors = 1;
  command_line
      .add("--floors", &floors,
           "So many floors side by side in one map: the same plan, each with the furniture of the next seed")
      .range(1, 100);
  command_line.addParameters(parametersOf(options));
  return map_matcher::tools::run(command_line, argc, argv, [&] {
    map_matcher::tools::FileRoles().writesMap("--output", output).requireDistinct();
    const map_matcher::grid::OccupancyGrid building = map_matcher::simulation::officeFloors(options, floors);
    map_matcher::grid::saveMap(building, output);
    std::cout << output << ": " << building.width() << " x " << building.height() << " cells of "
              << building.resolution() << " m, seed " << options.seed << '\n';
    return map_matcher::tools::kDone;
  });
}
