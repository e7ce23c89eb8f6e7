/// \file
/// The best pose of all, with proof, and the best ones elsewhere: branch and bound over translation and rotation.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "map_matcher/search/counting/score_kernel.hpp"
#include "map_matcher/search/counting/search_window.hpp"
#include "map_matcher/search/counting/widened_grids.hpp"
#include "map_matcher/search/exact/rotation_blocks.hpp"
#include "map_matcher/search/two_stage/branch_and_bound.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// What counts as another place than a pose: the session's centre lies farther off, or the session is turned by more.
struct Distinction {
  double distance = 0.0;  ///< Between the two translations [cells], at least 0.
  double angle = 0.0;     ///< Between the two rotations [rad], at least 0.
};

/// One exact search: over all translations of the windows and all rotations.
struct ExactProblem {
  const WidenedGrids& reference;
  const RotationBlocks& rotations;
  std::vector<SearchWindow> windows{};  ///< Translations under each rotation; empty: all.
  std::int32_t min_count = 1;           ///< Fewest matched cells that are an answer.
  std::int32_t known_count = 0;         ///< Matched cells of a pose that is known to be among those searched: a start.
  std::optional<double> known_worth{};  ///< What that pose is worth, if the caller knows; it saves work, nothing else.
  Distinction distinction{};
  std::int32_t runner_up_gap = 1 << 30;  ///< By how many cells a runner-up may at most be below the best pose, and a
                                         ///< further place below what the one worth most is worth.
  int most_places = 2;                   ///< Places that are looked for, the best one included; at least that one.
  /// What a place is worth [matched cells], at most its count; empty: its count. Called once for each place that was
  /// found, the best first, by the thread that called exactSearch().
  std::function<double(const SearchPose&)> worth{};
};

/// How a search is done; nothing here changes its answer, unless the deadline passes.
struct ExactSettings {
  int threads = 1;                ///< At least 1.
  std::optional<int> root_level;  ///< Level of the initial nodes, at most that of the reference, with a look at nodes
                                  ///< one level above if there are any; else the cheapest.
  std::int64_t most_stored_nodes = std::int64_t{1} << 23;  ///< Initial nodes that are kept, 16 bytes each; those of
                                                           ///< further blocks are scored again when their turn comes.
  work::Deadline deadline;
  ScoreKernel kernel;
};

/// What a search found and what it took. All of it holds wherever a deadline ended the search: bounds are those of what
/// was found and of all that was left. Poses are ranked by count; among equal ones the first by rotation, then y,
/// then x, is the better one, so that the answer does not depend on the number of threads or the order of work.
struct ExactOutcome {
  std::optional<SearchPose> best;       ///< Nothing when no pose reaches min_count; unless proven, the best so far.
  std::optional<SearchPose> runner_up;  ///< The best pose elsewhere; nothing when the gap to it is larger, and unless
                                        ///< `best` is proven; unless proven itself, the best so far.
  /// All places that were found, the best first: the best pose of all, the best one distinct from it, the best one
  /// distinct from both, and so on. Unless `complete`, the last one is the best so far.
  std::vector<SearchPose> places;
  std::int32_t upper_bound = 0;      ///< No pose has more matched cells.
  std::int32_t runner_up_bound = 0;  ///< No pose elsewhere has more matched cells.
  std::int32_t elsewhere_bound = 0;  ///< No pose that is distinct from all places has more matched cells.
  bool best_proven = false;          ///< Whether `best` is the best of all, or nothing reaches min_count.
  bool runner_up_proven = false;     ///< The same for the runner-up. Both are true unless the deadline passed, or
                                     ///< no runner-up was looked for.
  bool complete = false;             ///< Whether no further place reaches min_count and is within runner_up_gap of
                                     ///< what the others are worth, or most_places were found.
  bool stopped = false;              ///< Whether the stop token was set before the proofs were complete.
  std::int64_t nodes_scored = 0;
  std::int64_t nodes_expanded = 0;
  double root_time = 0.0;   ///< Scoring the initial nodes [s].
  double below_time = 0.0;  ///< All that is below them [s].
};

/// Finds the best pose, the runner-up and further places. Returns within 50 ms of the deadline, with the best poses so
/// far.
ExactOutcome exactSearch(const ExactProblem& problem, const ExactSettings& settings);

}  // namespace map_matcher::search
