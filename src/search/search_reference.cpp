#include "map_matcher/search/search_reference.hpp"

#include <algorithm>
#include <cmath>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/grid/resample.hpp"

namespace map_matcher {
namespace {

PrecomputedGrids poolWalls(const OccupancyGrid& grid, const MatchOptions& options, int top_level) {
  return {grid.width(), grid.height(), occupiedCells(grid, static_cast<std::int8_t>(options.occupied_threshold)),
          top_level};
}

}  // namespace

double nearestHalving(double resolution, double coarse_resolution) {
  const double halvings = std::max(0.0, std::round(std::log2(coarse_resolution / resolution)));
  return resolution * std::exp2(halvings);
}

int exactTopLevel(double resolution) {
  constexpr double kWidestNode = 1.6;  // [m]
  constexpr int kHighest = 5;
  return std::clamp(static_cast<int>(std::lround(std::log2(kWidestNode / resolution))), 1, kHighest);
}

SearchReference::SearchReference(const OccupancyGrid& reference, double resolution, const MatchOptions& options)
    : fine_resolution_(resolution),
      coarse_resolution_(nearestHalving(resolution, options.coarse_resolution)),
      fine_(poolWalls(resample(reference, resolution), options, kFineRootLevel)),
      coarse_(poolWalls(resample(reference, coarse_resolution_), options, kCoarseRootLevel)) {
  const double offset = -options.reference_map_cell_offset * reference.resolution();
  T_reference_grid_ = reference.geometry().T_map_grid * Rigid2{offset, offset, 0.0};
  if (options.search == "exact") {
    const OccupancyGrid grid = resample(reference, resolution);
    exact_.emplace(grid.width(), grid.height(),
                   occupiedCells(grid, static_cast<std::int8_t>(options.occupied_threshold)),
                   options.hit_tolerance / resolution, exactTopLevel(resolution));
  }
}

}  // namespace map_matcher
