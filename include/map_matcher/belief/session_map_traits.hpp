/// \file
/// How the maps of a session are told from those of another.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::belief {

/// What shows of which session a map is.
struct SessionMapTraits {
  std::string frame;             ///< Frame of the map.
  std::string publisher;         ///< Who sends it; empty: not known.
  std::optional<double> stamp;   ///< Of the map [s]; nothing: it has none.
  double resolution = 0.0;       ///< Edge length of a cell [m].
  std::int64_t known_cells = 0;  ///< Cells that are not unknown [cells].
};

/// Maps with a smaller share of the known cells of the one before were begun anew: what a mapper has seen it keeps, but
/// for the odd cell.
constexpr double kKeptShare = 0.5;

/// Why `next` is no map of the session of `last`: another frame, publisher or resolution, an earlier stamp, or a map
/// that was begun anew. Empty when it may be one.
std::string whyAnotherSession(const SessionMapTraits& last, const SessionMapTraits& next);

/// A number that two maps share only if they are the same, cell by cell and in place.
std::uint64_t digestOf(const grid::OccupancyGrid& map);

}  // namespace map_matcher::belief
