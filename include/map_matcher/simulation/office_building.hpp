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
  double resolution = 0.02;            ///< [m] Edge length of a cell.
  double length = 55.0;                ///< [m] Along x, outer walls included.
  double width = 15.0;                 ///< [m] Along y, outer walls included.
  double wall_thickness = 0.08;        ///< [m] Between rooms; at least one cell is drawn.
  double outer_wall_thickness = 0.12;  ///< [m] At least one cell is drawn.
  double door_width = 0.95;            ///< [m] Of an ordinary door; some are wider.
  bool furnished = true;               ///< Whether there is anything but walls and doors.
};

/// The parameters that fill `options`.
parameters::ParameterList parametersOf(OfficeBuildingOptions& options);

/// A floor with a corridor that shifts sideways at a foyer, rooms of many sizes on both sides, a hall at one end,
/// doors, shafts, pillars and furniture as a lidar near the floor sees it. Nothing is symmetric or repeated. A robot of
/// up to 0.3 m radius can reach every room from every other. The walls are closed: no ray gets out.
///
/// Cells are free inside, occupied where something stands, and unknown around the building (0.5 m on every side); the
/// lower left outer corner of the building is the origin of the map frame. The same seed gives the same plan at every
/// resolution. Throws std::invalid_argument that names every option out of its range.
grid::OccupancyGrid officeBuilding(const OfficeBuildingOptions& options);

}  // namespace map_matcher::simulation
