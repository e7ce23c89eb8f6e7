// Writes the map of a generated office floor.

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "command_line.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/simulation/office_building.hpp"

int main(int argc, char** argv) {
  CLI::App app("Generates the map of an office floor: the same seed gives the same floor at every resolution.",
               "generate_building");
  map_matcher::OfficeBuildingOptions options;
  std::string output;
  app.add_option("--output", output, "YAML file to write; a PGM image of the same name is written beside it")
      ->required();
  map_matcher::tools::addSeed(app, "--seed", options.seed, "Which floor");
  map_matcher::tools::addOptions(app, parametersOf(options));
  app.footer("Exit status: 0 written, 2 bad input.\n");
  return map_matcher::tools::run(app, argc, argv, [&] {
    const map_matcher::OccupancyGrid building = map_matcher::officeBuilding(options);
    map_matcher::saveMap(building, output);
    std::cout << output << ": " << building.width() << " x " << building.height() << " cells of "
              << building.resolution() << " m, seed " << options.seed << '\n';
    return map_matcher::tools::kDone;
  });
}
