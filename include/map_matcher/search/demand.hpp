/// \file
/// What a search is to find out.
#pragma once

#include <functional>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/search/search_result.hpp"

namespace map_matcher::search {

/// What the caller wants to know for sure; it decides how far an exact search looks.
struct Demand {
  double min_hit_ratio = 0.6;  ///< Places with a smaller share of hits need not be found, 0 to 1.
  double margin = 0.1;         ///< Nor do places elsewhere whose share is farther below what the best is worth, 0 to 1.
  int most_places = 8;         ///< Nor more places than these; fewer than 1 count as 1, and 1 leaves out the runner-up.
  /// What a place is worth, at most its hit ratio; empty: its hit ratio. Called from the thread that searches, one call
  /// at a time: once for each place, and once for the place that an exact search begins with.
  std::function<double(const Place&)> worth{};
  /// Where the session may lie, T_reference_session each, as after an earlier map of it: an exact search begins near
  /// the one with most hits, unless the two stages' answer has more. What it finds and proves is the same, but sooner,
  /// which matters where a deadline would have ended it.
  std::vector<grid::Rigid2> starts{};
};

}  // namespace map_matcher::search
