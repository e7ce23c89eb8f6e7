#include "map_matcher/search/exact/exact_search.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
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
    outcome_.upper_bound = outcome_.runner_up_bound = outcome_.elsewhere_bound = problem_.rotations.numCells();
    findBest();
    if (outcome_.best && outcome_.best_proven) {
      findOthers();
    }
    if (outcome_.best_proven && !outcome_.best) {
      outcome_.runner_up_proven = outcome_.complete = true;
    }
    for (const BlockSearch& search : searches_) {
      outcome_.nodes_scored += search.nodesScored();
      outcome_.nodes_expanded += search.nodesExpanded();
    }
    outcome_.stopped = settings_.deadline.stopped() && !outcome_.complete;
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

  /// What the first initial nodes reach. Where the pose that is known is likely to be the best, they serve the searches
  /// for other places as well. It hardly is where it is worth much less than its matched cells: then there are far more
  /// nodes as good as its runner-up than as good as that of the best.
  std::int32_t firstThreshold() const {
    const std::int32_t best = bestThreshold();
    const double worth = problem_.known_worth.value_or(best);
    if (problem_.known_count < problem_.min_count || problem_.most_places < 2 ||
        worth < best - problem_.runner_up_gap / 2.0) {
      return best;
    }
    return std::min({best, runnerUpThreshold(best), problem_.most_places > 2 ? thresholdFor(worth) : best});
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
    outcome_.upper_bound = outcome_.runner_up_bound = outcome_.elsewhere_bound = found.bound;
    takePlace(found);
  }

  /// The runner-up, by matched cells alone, then what else may be worth as much as the places so far.
  void findOthers() {
    if (!lookFurther()) {
      outcome_.complete = true;
      return;
    }
    const std::optional<Found> runner_up = findElsewhere(runnerUpThreshold(outcome_.best->count));
    if (!runner_up) {
      return;
    }
    outcome_.runner_up = runner_up->best;
    outcome_.runner_up_proven = runner_up->proven;
    outcome_.runner_up_bound = outcome_.elsewhere_bound;
    bool proven = runner_up->proven;
    while (proven && lookFurther() && furtherThreshold() <= outcome_.elsewhere_bound) {
      const std::optional<Found> found = findElsewhere(furtherThreshold());
      proven = found && found->proven;
    }
    outcome_.complete = proven;
  }

  bool lookFurther() const { return static_cast<int>(outcome_.places.size()) < problem_.most_places; }

  /// Matched cells without which no further place is worth as much as the best so far, less the gap: it is worth its
  /// matched cells at most.
  std::int32_t furtherThreshold() const { return thresholdFor(largest_worth_); }

  std::int32_t thresholdFor(double worth) const {
    constexpr double kRounding = 1e-6;  // of a worth that is a share of all cells
    const double least =
        std::floor(std::min<double>(worth, problem_.rotations.numCells()) + kRounding) - problem_.runner_up_gap;
    return std::max({1, problem_.min_count, static_cast<std::int32_t>(std::max(0.0, least))});
  }

  /// The best pose that is distinct from all places so far, if it reaches `threshold`, and takes it for a place.
  /// Nothing when the deadline passed before the search began.
  std::optional<Found> findElsewhere(std::int32_t threshold) {
    if (threshold < root_threshold_ && !scoreRoots(threshold)) {
      return std::nullopt;
    }
    std::vector<ExcludedNeighbourhood> excluded;
    for (const SearchPose& place : outcome_.places) {
      excluded.emplace_back(place, problem_);
    }
    Incumbent incumbent(threshold, std::move(excluded));
    const Found found = searchBlocks(incumbent);
    outcome_.elsewhere_bound = std::min(outcome_.elsewhere_bound, found.bound);
    takePlace(found);
    return found;
  }

  void takePlace(const Found& found) {
    if (found.best) {
      outcome_.places.push_back(*found.best);
      const double worth = problem_.worth ? problem_.worth(*found.best) : found.best->count;
      largest_worth_ = std::max(largest_worth_, worth);  // which no worth that is not a number is
    }
  }

  const ExactProblem& problem_;
  const ExactSettings& settings_;
  std::vector<BlockSearch> searches_;
  std::vector<RotationBlock> blocks_;
  std::int32_t root_threshold_ = 0;  // that the initial nodes at hand reach
  double largest_worth_ = 0.0;       // of all places so far [cells]
  ExactOutcome outcome_;
};

}  // namespace

ExactOutcome exactSearch(const ExactProblem& problem, const ExactSettings& settings) {
  return ExactSearch(problem, settings).run();
}

}  // namespace map_matcher::search
