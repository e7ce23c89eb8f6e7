/// \file
/// Which translations a search looks at.
#pragma once

#include <optional>

#include "map_matcher/search/counting/precomputed_grids.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/counting/weighted_cells.hpp"
#include "map_matcher/search/counting/widened_grids.hpp"

namespace map_matcher::search {

/// Inclusive box of translations [cells of the stage]; empty when a `last` lies below its `first`.
struct SearchWindow {
  grid::Cell first;
  grid::Cell last;

  bool empty() const { return last.x < first.x || last.y < first.y; }
};

/// A window of all translations that a search can tell apart.
constexpr SearchWindow everywhere() {
  constexpr int kFar = 1 << 28;  // [cells]
  return {{-kFar, -kFar}, {kFar, kFar}};
}

/// Translations that both windows hold.
SearchWindow intersection(const SearchWindow& a, const SearchWindow& b);

/// Smallest window that holds both; {everywhere().last, everywhere().first} is the empty one to begin with.
SearchWindow hull(const SearchWindow& a, const SearchWindow& b);

/// Smallest window that holds every translation at which at least `min_matches` of the rotated cells lie within the
/// bounding box of the reference's walls, or at most `reach` cells beside it. No translation outside it can match as
/// many, so nothing is lost.
SearchWindow reachableWindow(const PrecomputedGrids& reference, const RotatedCells& cells, int min_matches,
                             int reach = 0);

/// The same for the cells of a node of the exact search: a window for the translations at which any pose of the node
/// has at least `min_matches`.
SearchWindow reachableWindow(const WidenedGrids& reference, const BlockShape& shape, const WeightedCells& cells,
                             int min_matches);

}  // namespace map_matcher::search
