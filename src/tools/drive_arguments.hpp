/// \file
/// The arguments of programs that simulate a drive.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "map_matcher/simulation/rectangle.hpp"

namespace map_matcher::tools {

/// The rectangle that an option names by x_min y_min x_max y_max. Throws std::invalid_argument when there is nothing in
/// it.
simulation::Rectangle rectangleOf(const std::string& option, const std::vector<double>& values);

/// Where and how to drive, as asked for on the command line.
class DriveArguments {
 public:
  /// Takes a first look at the command line: the robot that it names has defaults of its own.
  DriveArguments(int argc, char** argv);

  /// Adds the options --map, --building-seed, --seed, --robot, --itinerary, --start, --area, --waypoints and one for
  /// each parameter of a drive. This object must outlive the parsing.
  void describe(CommandLine& command_line);

  /// The map file among the files that are read.
  void addFiles(FileRoles& files) const { files.readsMap("--map", map_); }

  /// The map to drive in. Throws as loadMap().
  grid::OccupancyGrid map() const;

  /// Throws std::invalid_argument for arguments that contradict each other.
  simulation::DriveOptions options() const;

 private:
  std::string map_;
  std::uint64_t building_seed_ = 1;
  std::string robot_ = "pioneer";
  std::string itinerary_;
  std::vector<double> start_;
  std::vector<double> waypoints_;
  std::vector<double> area_;
  simulation::DriveOptions drive_;
};

}  // namespace map_matcher::tools
