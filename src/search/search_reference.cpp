#include "map_matcher/search/search_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <future>
#include <optional>
#include <vector>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/grid/resample.hpp"
#include "map_matcher/search/refinement/pose_refiner.hpp"

namespace map_matcher::search {
double nearestHalving(double resolution, double coarse_resolution) {
  const double halvings = std::max(0.0, std::round(std::log2(coarse_resolution / resolution)));
  return resolution * std::exp2(halvings);
}

int exactTopLevel(double resolution) {
  constexpr double kWidestNode = 1.6;  // [m]
  constexpr int kHighest = 5;
  return std::clamp(static_cast<int>(std::lround(std::log2(kWidestNode / resolution))), 1, kHighest);
}

SearchReference::SearchReference(const grid::OccupancyGrid& reference, double resolution, const SearchOptions& options,
                                 const work::Deadline& deadline)
    : fine_resolution_(resolution), coarse_resolution_(nearestHalving(resolution, options.coarse_resolution)) {
  const double offset = -options.reference_map_cell_offset * reference.resolution();
  T_reference_grid_ = reference.geometry().T_map_grid * grid::Rigid2{offset, offset, 0.0};
  const auto threshold = static_cast<std::int8_t>(options.occupied_threshold);
  const auto before_row = [&deadline] { deadline.throwIfPassed(); };
  const bool resampled = resolution != reference.resolution();
  const std::optional<grid::OccupancyGrid> at_resolution =
      resampled ? std::make_optional(grid::resample(reference, resolution, before_row)) : std::nullopt;
  const grid::OccupancyGrid& grid = resampled ? *at_resolution : reference;
  const std::vector<grid::Cell> walls = grid::occupiedCells(grid, threshold);
  std::vector<std::future<void>> others;
  if (options.search == "exact") {
    others.push_back(std::async(std::launch::async, [&] {
      exact_.emplace(grid.width(), grid.height(), walls, options.hit_tolerance / resolution, exactTopLevel(resolution),
                     deadline);
    }));
    others.push_back(std::async(std::launch::async, [&] {
      walls_.emplace(grid.width(), grid.height(), walls, farthestThatMatters(options.hit_tolerance, resolution),
                     deadline);
    }));
  }
  fine_.emplace(grid.width(), grid.height(), walls, kFineRootLevel, -1, deadline);
  const grid::OccupancyGrid coarse = grid::resample(reference, coarse_resolution_, before_row);
  coarse_.emplace(coarse.width(), coarse.height(), grid::occupiedCells(coarse, threshold), kCoarseRootLevel,
                  kCoarseTopBandLevel, deadline);
  for (std::future<void>& other : others) {
    other.get();
  }
}

}  // namespace map_matcher::search
