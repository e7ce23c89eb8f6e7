/// \file
/// What depends only on the reference map, built once for each.
#pragma once

#include <optional>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/counting/precomputed_grids.hpp"
#include "map_matcher/search/counting/widened_grids.hpp"
#include "map_matcher/search/refinement/distance_field.hpp"
#include "map_matcher/search/search_options.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// The reference map at the resolutions of both stages, and for the exact search if options.search says so; built on
/// several threads. Immutable, hence thread-safe.
class SearchReference {
 public:
  /// Highest levels of the initial nodes. The report starts at H of eq. 4.1, where a node is as wide as the session
  /// map; nodes so wide match nearly every cell and none is pruned, so that starting here gives the same answer sooner.
  static constexpr int kCoarseRootLevel = 2;
  static constexpr int kCoarseTopBandLevel = 4;  ///< For passing over empty parts of large maps.
  static constexpr int kFineRootLevel = 0;

  /// Pools `reference` at `resolution` [m] (its own, or a coarser one when the session map is coarser) for the fine
  /// stage, and at the halving of it that is nearest to options.coarse_resolution for the coarse stage. Throws
  /// DeadlinePassed within 50 ms when that comes before the end, std::invalid_argument for a map too large for the
  /// search and std::system_error when no thread can be started.
  SearchReference(const grid::OccupancyGrid& reference, double resolution, const SearchOptions& options,
                  const work::Deadline& deadline = work::Deadline());

  double resolution() const { return fine_resolution_; }          ///< Of the fine stage [m].
  double coarseResolution() const { return coarse_resolution_; }  ///< Of the coarse stage [m].
  const PrecomputedGrids& fine() const { return *fine_; }
  const PrecomputedGrids& coarse() const { return *coarse_; }
  const WidenedGrids& exact() const { return *exact_; }   ///< Of options.search = "exact" alone.
  const DistanceField& walls() const { return *walls_; }  ///< For refinement, of options.search = "exact" alone.
  bool hasWalls() const { return fine_->firstWall().x <= fine_->lastWall().x; }

  /// Pose of the searched grids' corner in the reference map frame: the map's origin, with reference_map_cell_offset.
  const grid::Rigid2& T_reference_grid() const { return T_reference_grid_; }

 private:
  double fine_resolution_;
  double coarse_resolution_;
  grid::Rigid2 T_reference_grid_;
  std::optional<PrecomputedGrids> fine_;
  std::optional<PrecomputedGrids> coarse_;
  std::optional<WidenedGrids> exact_;
  std::optional<DistanceField> walls_;
};

/// Highest level of the exact search: nodes of up to 1.6 m. Wider ones match nearly everything in a building.
int exactTopLevel(double resolution);

/// The halving resolution * 2^k, k >= 0, nearest to `coarse_resolution` on a logarithmic scale [m]: 0.16 m or 0.2 m for
/// maps of 2 cm or 5 cm and a coarse resolution of 0.2 m.
double nearestHalving(double resolution, double coarse_resolution);

}  // namespace map_matcher::search
