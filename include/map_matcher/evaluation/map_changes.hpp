/// \file
/// What changed in a building between two maps of it.
#pragma once

#include <string>

#include "map_matcher/evaluation/map_quality.hpp"

namespace map_matcher::evaluation {

/// The walls of two maps by what the other one has there: on_walls are there still, falsely_occupied has become free
/// (or was free before), unknown the other map did not see.
struct MapChanges {
  MapQuality before;  ///< Of the older map's walls.
  MapQuality after;   ///< Of the newer map's walls.
};

/// Compares the maps with the newer one at `T_before_after`. `tolerance` [m], at least 0: walls that are no farther
/// apart are the same.
MapChanges mapChanges(const grid::OccupancyGrid& before, const grid::OccupancyGrid& after,
                      const grid::Rigid2& T_before_after, double tolerance);

/// Draws both on each other, in the older grid's axes: walls that are still there dark, what is gone red, what is new
/// green, walls that the other map did not see grey. The format follows the ending of `path` (.png recommended). Throws
/// std::runtime_error when the file cannot be written.
void writeChangesImage(const std::string& path, const grid::OccupancyGrid& before, const grid::OccupancyGrid& after,
                       const grid::Rigid2& T_before_after, double tolerance);

}  // namespace map_matcher::evaluation
