/// \file
/// Office floors that nobody had to measure.
#pragma once

#include <cstdint>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::simulation {

/// An office floor of about the size of the report's section 3.3.1. Ranges stand in parametersOf().
struct OfficeBuildingOptions {
  std::uint64_t seed = 1;              ///< Of the floor plan and the furniture.
  std::uint64_t furniture_seed = 0;    ///< Of the furniture alone; 0: that of the floor plan.
  std::uint64_t change_seed = 1;       ///< Which furniture is moved, where to, and which doors are shut.
  double resolution = 0.02;            ///< [m] Edge length of a cell.
  double length = 55.0;                ///< [m] Along x, outer walls included.
  double width = 15.0;                 ///< [m] Along y, outer walls included.
  double wall_thickness = 0.08;        ///< [m] Between rooms; at least one cell is drawn.
  double outer_wall_thickness = 0.12;  ///< [m] At least one cell is drawn.
  double door_width = 0.95;            ///< [m] Of an ordinary door; some are wider.
  bool furnished = true;               ///< Whether there is anything but walls and doors.
  double moved_furniture = 0.0;        ///< Share of the furniture that was moved elsewhere in its room.
  double shut_doors = 0.0;             ///< Share of the ordinary doors that are shut; as walls to everybody.
  double copied_rooms = 0.0;           ///< [m] Width of rooms that are all the same; 0: every room is different.
  bool copied_furniture = true;        ///< Whether such rooms have the same furniture, too.
};

/// The parameters that fill `options`.
parameters::ParameterList parametersOf(OfficeBuildingOptions& options);

/// A floor with a corridor that shifts sideways at a foyer, rooms of many sizes on both sides, a hall at one end,
/// doors, shafts, pillars and furniture as a lidar near the floor sees it. Nothing is symmetric or repeated unless
/// copied_rooms is given. A robot of up to 0.3 m radius can reach every room from every other, unless doors are shut.
/// The walls are closed: no ray gets out.
///
/// Cells are free inside, occupied where something stands, and unknown around the building (0.5 m on every side); the
/// lower left outer corner of the building is the origin of the map frame. The same seed gives the same plan at every
/// resolution. Throws std::invalid_argument that names every option out of its range.
grid::OccupancyGrid officeBuilding(const OfficeBuildingOptions& options);

/// So many floors with one plan side by side, the first one at the origin, each farther up in y: as officeBuilding()
/// would make them with the furniture_seed of `options`, which is that of the first, and those that follow. Throws as
/// it does, and for less than one floor.
grid::OccupancyGrid officeFloors(const OfficeBuildingOptions& options, int num_floors);

}  // namespace map_matcher::simulation
