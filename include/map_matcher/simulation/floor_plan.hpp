/// \file
/// The rooms, corridors and doors of an office floor.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/simulation/office_building.hpp"
#include "map_matcher/simulation/rectangle.hpp"

namespace map_matcher::simulation {

/// What a space is for.
enum class SpaceKind {
  kCorridor,  ///< Runs along the floor; two of them meet in the foyer.
  kFoyer,     ///< Open to the corridors on both sides.
  kHall,      ///< Closes one end of the floor over its whole width.
  kRoom,      ///< Anything else, with a door.
};

/// A rectangle of floor between the centre lines of the walls around it [m]; at the outside of the building between
/// their outer faces. Spaces that overlap are open to each other.
struct Space {
  SpaceKind kind;
  Rectangle walls;
  std::optional<std::size_t> copy_of = {};  ///< Index of the space that it is a copy of, moved along x.
};

/// An opening in a wall between two spaces.
struct Door {
  Eigen::Vector2d centre;  ///< On the centre line of the wall [m].
  double width;            ///< Clear [m].
  bool in_wall_along_x;    ///< Whether the wall runs along x.
  bool is_shut = false;    ///< Whether nobody gets or looks through.

  /// The floor in front of the door on both sides that has to stay empty [m].
  Rectangle approach() const;
};

/// A floor from (0, 0) to (length, width) [m].
struct FloorPlan {
  double length = 0.0;
  double width = 0.0;
  std::vector<Space> spaces;
  std::vector<Door> doors;
  std::vector<Rectangle> passages;  ///< Floor that has to stay empty beside that in front of doors [m].
};

/// The plan of the floor that officeBuilding makes of these options. Throws std::invalid_argument that names every
/// option out of its range.
FloorPlan drawFloorPlan(const OfficeBuildingOptions& options);

}  // namespace map_matcher::simulation
