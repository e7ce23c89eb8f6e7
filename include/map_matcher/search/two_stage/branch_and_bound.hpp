/// \file
/// Branch and bound, depth first (report algorithm 1).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "map_matcher/search/counting/precomputed_grids.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/counting/search_window.hpp"
#include "map_matcher/search/two_stage/rotation_bands.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// One search: which rotation and whole-cell translation put the most session cells on walls.
struct SearchProblem {
  const PrecomputedGrids& reference;
  /// The session cells under a rotation, for all the same, non-zero number. Called when they are needed, by each
  /// thread.
  std::function<RotatedCells(int)> cells;
  std::vector<SearchWindow> windows;  ///< Translations to look at under each rotation.
  std::vector<std::int32_t> order;    ///< Rank of each rotation in the initial node list; empty: by score alone.
  std::int32_t min_count = 1;         ///< Fewest matched cells that are an answer: the initial threshold.
  int root_level = 0;                 ///< Level of the initial nodes, at most the reference's top level.
  /// Bands of all rotations, in the order in which they are scored: the sooner a good one comes, the sooner the others
  /// are given up. Empty: rotations are scored one by one.
  std::vector<RotationBand> bands{};
  std::function<RotatedCells(double)> turned{};  ///< The session cells turned by an angle [rad]; called for bands.
  int threads = 1;  ///< At least 1. The answer is the same with any number, unless the search gives up.
  /// Nodes that are expanded at most before the search gives up with the best pose so far; nothing: no limit. For an
  /// answer that need not be the best one.
  std::optional<std::int64_t> most_expansions{};
};

/// A pose of the search.
struct SearchPose {
  int rotation = 0;        ///< Index into SearchProblem::windows.
  grid::Cell translation;  ///< [cells of the stage]
  std::int32_t count = 0;  ///< Matched session cells.
};

/// What a search found and what it took.
struct SearchOutcome {
  std::optional<SearchPose> best;  ///< Nothing when no pose reaches min_count.
  bool stopped = false;            ///< Whether the deadline passed before the end; `best` is then the best so far.
  bool gave_up = false;            ///< Whether most_expansions were done before the end; so it is then.
  std::int64_t nodes_scored = 0;
  std::int64_t nodes_expanded = 0;
  double rotation_expansion_time = 0.0;  ///< Lines 4 to 10: scoring the initial node list [s].
  double depth_first_search_time = 0.0;  ///< From line 11 on [s].
};

/// Finds the pose with the most matched cells. Among equal ones the first by rotation, then y, then x, wins, so that
/// the answer does not depend on the number of threads or the order of work.
SearchOutcome branchAndBound(const SearchProblem& problem, const work::Deadline& deadline = work::Deadline());

}  // namespace map_matcher::search
