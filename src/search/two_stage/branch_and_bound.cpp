#include "map_matcher/search/two_stage/branch_and_bound.hpp"

#include <algorithm>
#include <cstddef>

#include "band_search.hpp"
#include "map_matcher/work/parallel.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

/// Each rotation on its own.
std::vector<RotationBand> oneByOne(std::size_t num_rotations) {
  std::vector<RotationBand> bands(num_rotations);
  for (std::size_t n = 0; n < num_rotations; ++n) {
    bands[n].rotations = {static_cast<int>(n)};
  }
  return bands;
}

/// All threads of a search and what they share.
class DepthFirstSearch {
 public:
  DepthFirstSearch(const SearchProblem& problem, const work::Deadline& deadline)
      : problem_(problem), incumbent_(problem.min_count) {
    for (int thread = 0; thread < std::max(1, problem.threads); ++thread) {
      searches_.emplace_back(problem, deadline, incumbent_);
    }
  }

  SearchOutcome run() {
    SearchOutcome outcome;
    work::Stopwatch watch;
    const bool scored = scoreInitialNodes();
    outcome.rotation_expansion_time = watch.lap();
    outcome.stopped = !scored || !searchInitialNodes();
    outcome.depth_first_search_time = watch.lap();
    outcome.best = incumbent_.best();
    for (const BandSearch& search : searches_) {
      outcome.nodes_scored += search.nodesScored();
      outcome.nodes_expanded += search.nodesExpanded();
      outcome.gave_up = outcome.gave_up || search.gaveUp();
    }
    return outcome;
  }

 private:
  // Lines 4 to 10: all rotations at the root level, all translations on its stride.
  bool scoreInitialNodes() {
    const std::vector<RotationBand> single =
        problem_.bands.empty() ? oneByOne(problem_.windows.size()) : std::vector<RotationBand>{};
    const std::vector<RotationBand>& bands = problem_.bands.empty() ? single : problem_.bands;
    return work::parallelWhile(searches_, bands.size(),
                               [&bands](BandSearch& search, std::size_t n) { return search.scoreBand(bands[n]); });
  }

  // From line 11 on, the best initial node first.
  bool searchInitialNodes() {
    std::vector<SearchNode> nodes;
    for (const BandSearch& search : searches_) {
      std::copy_if(search.initialNodes().begin(), search.initialNodes().end(), std::back_inserter(nodes),
                   [this](const SearchNode& node) { return !incumbent_.prunes(node); });
    }
    std::sort(nodes.begin(), nodes.end(),
              [this](const SearchNode& a, const SearchNode& b) { return searchedAfter(problem_, b, a); });
    return work::parallelWhile(searches_, nodes.size(),
                               [&nodes](BandSearch& search, std::size_t n) { return search.searchBelow(nodes[n]); });
  }

  const SearchProblem& problem_;
  Incumbent incumbent_;
  std::vector<BandSearch> searches_;
};

}  // namespace

SearchOutcome branchAndBound(const SearchProblem& problem, const work::Deadline& deadline) {
  return DepthFirstSearch(problem, deadline).run();
}

}  // namespace map_matcher::search
