/// \file
/// Puts furniture into a floor plan without blocking a way.
#pragma once

#include <cstdint>
#include <vector>

#include "map_matcher/simulation/floor_plan.hpp"
#include "map_matcher/simulation/furniture.hpp"

namespace map_matcher::simulation {

/// What stands in one space of a plan. The pieces may reach into its walls, never beyond them.
struct FurnishedSpace {
  Rectangle floor;                ///< Between the faces of the walls [m].
  std::vector<Furniture> pieces;  ///< In the frame of the plan.
};

/// The seed of the furniture of these options.
std::uint64_t furnitureSeedOf(const OfficeBuildingOptions& options);

/// Furniture for every space of the plan of these options, in the order of its spaces. Pieces touch a wall or leave a
/// passage of 0.85 m to it; between two pieces there is always such a passage, and nothing stands where people come in.
/// So the free floor of a space remains in one piece and every door can be reached. Furniture that is moved stands by
/// the same rules; what finds no other place is gone.
std::vector<FurnishedSpace> furnish(const FloorPlan& plan, const OfficeBuildingOptions& options);

}  // namespace map_matcher::simulation
