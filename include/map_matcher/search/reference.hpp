/// \file
/// A reference map that session maps are searched in.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/grid/seen_space.hpp"
#include "map_matcher/search/search_options.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::search {

/// A reference map with what the searches need of it, which is built when it is first asked for and kept. Thread-safe:
/// several searches may use it side by side.
class Reference {
 public:
  /// A reference map at the resolution that session maps of one resolution are searched at.
  struct Prepared {
    std::shared_ptr<const SearchReference> map;  ///< Null when it was stopped.
    double time = 0.0;                           ///< That building it took [s].
  };

  /// Takes a map of any resolution and origin; builds nothing yet. Of `options`, search, coarse_resolution,
  /// hit_tolerance, occupied_threshold and reference_map_cell_offset count.
  Reference(grid::OccupancyGrid grid, const SearchOptions& options);

  const grid::OccupancyGrid& grid() const { return grid_; }

  /// What the map says of places, free space included; made when it is first asked for.
  const grid::SeenSpace& seen() const;

  /// What session maps of `session_resolution` [m] are searched in: a finer one is searched in the reference's own
  /// cells, a coarser one needs the reference map at its own resolution. Builds it unless it was the last one asked
  /// for; gives that up, and keeps what it had, within 50 ms of a stop. Throws std::invalid_argument for a map too
  /// large for the search and std::system_error when no thread can be started; what it had is kept then, too.
  Prepared at(double session_resolution, const work::StopToken& stop = {}) const;

 private:
  grid::OccupancyGrid grid_;
  SearchOptions options_;
  mutable std::mutex mutex_;  // guards prepared_, and that it is built once
  mutable Prepared prepared_;
  mutable std::once_flag seen_made_;
  mutable std::optional<grid::SeenSpace> seen_;
};

}  // namespace map_matcher::search
