#include "map_matcher/search/exact/exact_search.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "block_search.hpp"
#include "map_matcher/work/parallel.hpp"
#include "map_matcher/work/stopwatch.hpp"
#include "root_level.hpp"

namespace map_matcher::search {
namespace {

/// What a search below the initial nodes found.
struct Found {
  std::optional<SearchPose> best;
  std::int32_t bound = 0;  // no pose that was searched for has more matched cells
  bool proven = false;     // whether `best` is the best of them, or nothing is
};

/// All threads of a search and what they share.
class ExactSearch {
 public:
  ExactSearch(const ExactProblem& problem, const ExactSettings& settings) : problem_(problem), settings_(settings) {
    work::Stopwatch watch;
    const RootLevels levels = rootLevels();
    outcome_.root_time = watch.lap();
    for (int thread = 0; thread < std::max(1, settings.threads); ++thread) {
      searches_.emplace_back(problem_, settings_, levels);
    }
    for (int first = 0; first < problem.rotations.count(); first += 1 << levels.sieve) {
      RotationBlock block;
      block.first_rotation = first;
      blocks_.push_back(block);
    }
  }

  ExactOutcome run() {
    outcome_.upper_bound = outcome_.runner_up_bound = problem_.rotations.numCells();
    findBest();
    if (outcome_.best && outcome_.best_proven) {
      findRunnerUp();
    }
    outcome_.runner_up_proven |= outcome_.best_proven && !outcome_.best;
    for (const BlockSearch& search : searches_) {
      outcome_.nodes_scored += search.nodesScored();
      outcome_.nodes_expanded += search.nodesExpanded();
    }
    outcome_.stopped = settings_.deadline.stopped() && !(outcome_.best_proven && outcome_.runner_up_proven);
    return outcome_;
  }

 private:
  RootLevels rootLevels() const {
    if (!settings_.root_level) {
      return cheapestRootLevels(problem_, settings_, firstThreshold());
    }
    return {*settings_.root_level, std::min(*settings_.root_level + 1, problem_.reference.topLevel())};
  }

  std::int32_t runnerUpThreshold(std::int32_t best) const { return std::max(1, best - problem_.runner_up_gap); }

  /// Calls work(search, block) for all blocks, each once, on all threads, until a call returns false; whether none did.
  template <typename Work>
  bool forEachBlock(const Work& work) {
    return work::parallelWhile(searches_, blocks_.size(),
                               [&](BlockSearch& search, std::size_t n) { return work(search, blocks_[n]); });
  }

  /// Scores the initial nodes that reach `threshold` and sorts the blocks, the best first. False when the deadline
  /// passed before that.
  bool scoreRoots(std::int32_t threshold) {
    work::Stopwatch watch;
    root_threshold_ = threshold;
    std::atomic<std::int64_t> num_stored{0};
    const bool complete = forEachBlock([&](BlockSearch& search, RotationBlock& block) {
      if (!search.scoreRoots(block, threshold)) {
        return false;
      }
      const auto size = static_cast<std::int64_t>(block.roots.size());
      block.stored = (num_stored += size) <= settings_.most_stored_nodes;
      if (!block.stored) {
        num_stored -= size;
        block.roots = {};
      }
      return true;
    });
    if (complete) {
      std::sort(blocks_.begin(), blocks_.end(), [](const RotationBlock& a, const RotationBlock& b) {
        return std::make_pair(-a.best_bound, a.first_rotation) < std::make_pair(-b.best_bound, b.first_rotation);
      });
    }
    outcome_.root_time += watch.lap();
    return complete;
  }

  /// Searches below all initial nodes that the incumbent does not prune.
  Found searchBlocks(Incumbent& incumbent) {
    work::Stopwatch watch;
    for (RotationBlock& block : blocks_) {
      block.rest.reset();
    }
    forEachBlock([&](BlockSearch& search, RotationBlock& block) {
      block.rest = searchBlock(search, block, incumbent);
      return *block.rest == 0;
    });
    // A deadline leaves nodes of the blocks that were at work, and blocks that were not begun.
    std::int32_t rest = 0;
    for (const RotationBlock& block : blocks_) {
      rest = std::max(rest, boundOfRest(block, incumbent));
    }
    outcome_.below_time += watch.lap();
    const std::optional<SearchPose> best = incumbent.best();
    return {best, std::max(best ? best->count : incumbent.threshold() - 1, rest), rest < incumbent.threshold()};
  }

  /// Bound of what the deadline left of a block, 0 for nothing.
  static std::int32_t searchBlock(BlockSearch& search, const RotationBlock& block, Incumbent& incumbent) {
    if (block.best_bound < incumbent.threshold()) {
      return 0;
    }
    if (block.stored) {
      return search.searchBelow(block, incumbent);
    }
    RotationBlock again;
    again.first_rotation = block.first_rotation;
    return search.scoreRoots(again, incumbent.threshold()) ? search.searchBelow(again, incumbent) : block.best_bound;
  }

  std::int32_t boundOfRest(const RotationBlock& block, const Incumbent& incumbent) const {
    if (block.rest) {
      return *block.rest;
    }
    return block.stored ? searches_.front().boundOf(block, incumbent) : block.best_bound;
  }

  std::int32_t bestThreshold() const { return std::max({1, problem_.min_count, problem_.known_count}); }

  /// What the first initial nodes reach. Where a pose is known, they serve the search for the runner-up as well.
  std::int32_t firstThreshold() const {
    const bool known = problem_.known_count >= problem_.min_count;
    return known ? std::min(bestThreshold(), runnerUpThreshold(bestThreshold())) : bestThreshold();
  }

  void findBest() {
    const std::int32_t threshold = bestThreshold();
    if (!scoreRoots(firstThreshold())) {
      return;
    }
    Incumbent incumbent(threshold);
    const Found found = searchBlocks(incumbent);
    outcome_.best = found.best;
    outcome_.best_proven = found.proven;
    outcome_.upper_bound = outcome_.runner_up_bound = found.bound;
  }

  void findRunnerUp() {
    const std::int32_t threshold = runnerUpThreshold(outcome_.best->count);
    if (threshold < root_threshold_ && !scoreRoots(threshold)) {
      return;
    }
    Incumbent incumbent(threshold, ExcludedNeighbourhood(*outcome_.best, problem_));
    const Found found = searchBlocks(incumbent);
    outcome_.runner_up = found.best;
    outcome_.runner_up_proven = found.proven;
    outcome_.runner_up_bound = std::min(found.bound, outcome_.best->count);
  }

  const ExactProblem& problem_;
  const ExactSettings& settings_;
  std::vector<BlockSearch> searches_;
  std::vector<RotationBlock> blocks_;
  std::int32_t root_threshold_ = 0;  // that the initial nodes at hand reach
  ExactOutcome outcome_;
};

}  // namespace

ExactOutcome exactSearch(const ExactProblem& problem, const ExactSettings& settings) {
  return ExactSearch(problem, settings).run();
}

}  // namespace map_matcher::search
