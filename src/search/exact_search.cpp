#include "map_matcher/search/exact_search.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>
#include <tuple>
#include <utility>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/search/stopwatch.hpp"

namespace map_matcher {
namespace {

/// Initial nodes that are kept, 12 bytes each; those of further blocks are scored again when their turn comes.
constexpr std::int64_t kMostStoredNodes = std::int64_t{1} << 23;

/// Poses first + [0, 2^level)^2 of the rotations rotation + [0, 2^level).
struct Node {
  std::int32_t bound;  // no pose of the node has more matched cells
  int rotation;
  Cell first;
  int level;
};

struct Root {
  std::int32_t bound;
  Cell first;
};

/// The initial nodes of a block of rotations.
struct Block {
  int first_rotation = 0;
  bool stored = false;  // whether `roots` holds its nodes, the best first
  std::int32_t best_bound = 0;
  std::vector<Root> roots;
};

/// Whether pose `a` is better than pose `b`.
bool better(const SearchPose& a, const SearchPose& b) {
  return std::make_tuple(-a.count, a.rotation, a.translation.y, a.translation.x) <
         std::make_tuple(-b.count, b.rotation, b.translation.y, b.translation.x);
}

/// Tells poses elsewhere from those around a winner.
class Surroundings {
 public:
  Surroundings(const SearchPose& winner, const ExactProblem& problem)
      : winner_(winner),
        problem_(problem),
        squared_distance_(problem.distinction.distance * problem.distinction.distance) {}

  /// Whether every pose of the node lies around the winner.
  bool holdAll(const Node& node) const {
    const int size = (1 << node.level) - 1;
    const double dx =
        std::max(std::abs(node.first.x - winner_.translation.x), std::abs(node.first.x + size - winner_.translation.x));
    const double dy =
        std::max(std::abs(node.first.y - winner_.translation.y), std::abs(node.first.y + size - winner_.translation.y));
    if (dx * dx + dy * dy > squared_distance_) {
      return false;
    }
    for (int k = 0; k <= size; ++k) {
      const int steps = node.rotation + k - winner_.rotation;
      if (std::abs(normalizeAngle(steps * problem_.rotations.step())) > problem_.distinction.angle) {
        return false;
      }
    }
    return true;
  }

 private:
  SearchPose winner_;
  const ExactProblem& problem_;
  double squared_distance_;
};

/// What the threads of a search hunt for: the best pose that is not excluded. Thread-safe.
class Quarry {
 public:
  /// `min_count` is at least 1.
  explicit Quarry(std::int32_t min_count, std::optional<Surroundings> excluded = std::nullopt)
      : threshold_(std::max(1, min_count)), excluded_(std::move(excluded)) {}

  std::int32_t threshold() const { return threshold_.load(std::memory_order_relaxed); }

  bool hopeless(const Node& node) const {
    const std::int32_t threshold = this->threshold();
    return node.bound < threshold || (node.bound == threshold && comesAfterBest(node)) ||
           (excluded_ && excluded_->holdAll(node));
  }

  void offer(const SearchPose& pose) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (pose.count >= threshold_ && (!best_ || better(pose, *best_))) {
      best_ = pose;
      threshold_ = pose.count;
    }
  }

  std::optional<SearchPose> best() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return best_;
  }

 private:
  /// Whether the best pose so far, of as many cells as the node's bound, comes before each pose of the node.
  bool comesAfterBest(const Node& node) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return best_ && !better({node.rotation, node.first, node.bound}, *best_);
  }

  mutable std::mutex mutex_;
  std::atomic<std::int32_t> threshold_;  // of the best pose once there is one; that many are needed to be as good
  std::optional<SearchPose> best_;
  std::optional<Surroundings> excluded_;
};

/// Work of one thread: scores initial nodes and searches below them, block by block.
class BlockSearch {
 public:
  BlockSearch(const ExactProblem& problem, const ExactSettings& settings) : problem_(problem), settings_(settings) {}

  std::int64_t nodesScored() const { return nodes_scored_; }
  std::int64_t nodesExpanded() const { return nodes_expanded_; }

  /// Bound of what the deadline left of the last block [cells].
  std::int32_t unsearchedBound() const { return unsearched_bound_; }

  /// Scores the initial nodes of a block and keeps those that reach `min_count`, the best first. False when the
  /// deadline passed before that.
  bool scoreRoots(Block& block, std::int32_t min_count) {
    block.roots.clear();
    const BlockShape shape{settings_.root_level};
    const WeightedCells cells = problem_.rotations.cells(shape, block.first_rotation, merger_);
    const SearchWindow window = intersection(windowOf(block.first_rotation, shape),
                                             reachableWindow(problem_.reference, shape, cells, min_count));
    const TileShape tile = (window.last.x - window.first.x) / shape.stride() < tileColumns(TileShape::kNarrow)
                               ? TileShape::kNarrow
                               : TileShape::kWide;
    for (int y = window.first.y; y <= window.last.y; y += shape.stride() * tileRows(tile)) {
      for (int x = window.first.x; x <= window.last.x; x += shape.stride() * tileColumns(tile)) {
        if (settings_.deadline.passed()) {
          return false;
        }
        scoreTile(tile, cells, {x, y}, window.last, min_count, block.roots);
      }
    }
    std::sort(block.roots.begin(), block.roots.end(), [](const Root& a, const Root& b) {
      return std::make_tuple(-a.bound, a.first.y, a.first.x) < std::make_tuple(-b.bound, b.first.y, b.first.x);
    });
    block.best_bound = block.roots.empty() ? 0 : block.roots.front().bound;
    return true;
  }

  /// Searches below the initial nodes of a block. False when the deadline passed before that.
  bool searchBelow(const Block& block, Quarry& quarry) {
    block_cells_.assign(static_cast<std::size_t>(2 << settings_.root_level), std::nullopt);
    first_rotation_ = block.first_rotation;
    for (const Root& root : block.roots) {
      if (root.bound < quarry.threshold()) {
        break;
      }
      if (!searchBelow(Node{root.bound, block.first_rotation, root.first, settings_.root_level}, quarry)) {
        unsearched_bound_ = root.bound;
        return false;
      }
    }
    return true;
  }

 private:
  /// Translations that any rotation of the node may have.
  SearchWindow windowOf(int first_rotation, const BlockShape& shape) const {
    if (problem_.windows.empty()) {
      return everywhere();
    }
    SearchWindow hull{everywhere().last, everywhere().first};
    const int end = std::min(problem_.rotations.count(), first_rotation + shape.stride());
    for (int n = first_rotation; n < end; ++n) {
      const SearchWindow& window = problem_.windows[static_cast<std::size_t>(n)];
      hull.first = {std::min(hull.first.x, window.first.x), std::min(hull.first.y, window.first.y)};
      hull.last = {std::max(hull.last.x, window.last.x), std::max(hull.last.y, window.last.y)};
    }
    return hull;
  }

  void scoreTile(TileShape tile, const WeightedCells& cells, const Cell& first, const Cell& last,
                 std::int32_t min_count, std::vector<Root>& roots) {
    const PooledLevel& level = problem_.reference.level(settings_.root_level);
    const int shift = problem_.reference.shift(settings_.root_level);
    const int stride = level.stride();
    const int columns = std::min(tileColumns(tile), (last.x - first.x) / stride + 1);
    const int rows = std::min(tileRows(tile), (last.y - first.y) / stride + 1);
    nodes_scored_ += static_cast<std::int64_t>(columns) * rows;
    if (!settings_.kernel.scoreTile(tile, level, cells, {first.x + shift, first.y + shift}, min_count, tile_)) {
      return;
    }
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const std::int32_t count = tile_[static_cast<std::size_t>(row * tileColumns(tile) + column)];
        if (count >= min_count) {
          roots.push_back({count, {first.x + column * stride, first.y + row * stride}});
        }
      }
    }
  }

  /// Depth first, the best child first. False when the deadline passed.
  bool searchBelow(const Node& root, Quarry& quarry) {
    nodes_.assign(1, root);
    while (!nodes_.empty()) {
      const Node node = nodes_.back();
      nodes_.pop_back();
      if (quarry.hopeless(node)) {
        continue;
      }
      if (node.level == 0) {
        quarry.offer({node.rotation, node.first, node.bound});
        continue;
      }
      if (settings_.deadline.passed()) {
        return false;
      }
      expand(node, quarry.threshold());
    }
    return true;
  }

  /// Adds the children that reach `min_count` to the nodes, the best last: both halves of the rotations, four quarters
  /// of the translations.
  void expand(const Node& node, std::int32_t min_count) {
    ++nodes_expanded_;
    const BlockShape shape{node.level - 1};
    const auto first_child = static_cast<std::ptrdiff_t>(nodes_.size());
    for (int half = 0; half < 2; ++half) {
      const int rotation = node.rotation + half * shape.stride();
      if (rotation < problem_.rotations.count()) {
        addChildren({0, rotation, node.first, shape.level}, min_count);
      }
    }
    std::sort(nodes_.begin() + first_child, nodes_.end(), [](const Node& a, const Node& b) {
      return std::make_tuple(-a.bound, a.rotation, a.first.y, a.first.x) >
             std::make_tuple(-b.bound, b.rotation, b.first.y, b.first.x);
    });
  }

  /// Adds the child `lower_left` and those one stride beside it that reach `min_count`.
  void addChildren(const Node& lower_left, std::int32_t min_count) {
    nodes_scored_ += 4;
    const BlockShape shape{lower_left.level};
    const int shift = problem_.reference.shift(lower_left.level);
    const Cell& first = lower_left.first;
    std::array<std::int32_t, 4> counts;
    if (!settings_.kernel.scoreChildren(problem_.reference.level(lower_left.level), cellsOf(shape, lower_left.rotation),
                                        {first.x + shift, first.y + shift}, min_count, counts)) {
      return;
    }
    const SearchWindow window = windowOf(lower_left.rotation, shape);
    for (int k = 0; k < 4; ++k) {
      const Cell child{first.x + (k & 1) * shape.stride(), first.y + (k >> 1) * shape.stride()};
      const std::int32_t count = counts[static_cast<std::size_t>(k)];
      const bool inside = child.x <= window.last.x && child.y <= window.last.y &&
                          child.x + shape.stride() > window.first.x && child.y + shape.stride() > window.first.y;
      if (count >= min_count && inside) {
        nodes_.push_back({count, lower_left.rotation, child, shape.level});
      }
    }
  }

  /// The cells of a node below the current block, kept until the next block.
  const WeightedCells& cellsOf(const BlockShape& shape, int rotation) {
    const int blocks_above = 1 << (settings_.root_level - shape.level);  // a binary tree, level by level
    const int index = blocks_above + ((rotation - first_rotation_) >> shape.level);
    std::optional<WeightedCells>& cells = block_cells_[static_cast<std::size_t>(index)];
    if (!cells) {
      cells = problem_.rotations.cells(shape, rotation, merger_);
    }
    return *cells;
  }

  const ExactProblem& problem_;
  const ExactSettings& settings_;
  CellMerger merger_;
  TileCounts tile_;
  int first_rotation_ = 0;
  std::vector<std::optional<WeightedCells>> block_cells_;
  std::vector<Node> nodes_;
  std::int32_t unsearched_bound_ = 0;
  std::int64_t nodes_scored_ = 0;
  std::int64_t nodes_expanded_ = 0;
};

/// All threads of a search and what they share.
class ExactSearch {
 public:
  ExactSearch(const ExactProblem& problem, const ExactSettings& settings) : problem_(problem), settings_(settings) {
    for (int thread = 0; thread < std::max(1, settings.threads); ++thread) {
      searches_.emplace_back(problem_, settings_);
    }
    for (int first = 0; first < problem.rotations.count(); first += 1 << settings.root_level) {
      Block block;
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
  std::int32_t runnerUpThreshold(std::int32_t best) const { return std::max(1, best - problem_.runner_up_gap); }

  /// Calls work(search, block) for all blocks, each once, on all threads, until a call returns false; whether none did.
  template <typename Work>
  bool forEachBlock(const Work& work) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> complete{true};
    const auto run = [&](BlockSearch& search) {
      for (std::size_t n = next++; n < blocks_.size() && complete; n = next++) {
        if (!work(search, blocks_[n])) {
          complete = false;
        }
      }
    };
    std::vector<std::thread> others;
    for (std::size_t thread = 1; thread < searches_.size(); ++thread) {
      others.emplace_back(run, std::ref(searches_[thread]));
    }
    run(searches_.front());
    for (std::thread& other : others) {
      other.join();
    }
    return complete;
  }

  /// Scores the initial nodes that reach `threshold` and sorts the blocks, the best first. False when the deadline
  /// passed before that.
  bool scoreRoots(std::int32_t threshold) {
    Stopwatch watch;
    root_threshold_ = threshold;
    std::atomic<std::int64_t> num_stored{0};
    const bool complete = forEachBlock([&](BlockSearch& search, Block& block) {
      if (!search.scoreRoots(block, threshold)) {
        return false;
      }
      const auto size = static_cast<std::int64_t>(block.roots.size());
      block.stored = (num_stored += size) <= kMostStoredNodes;
      if (!block.stored) {
        num_stored -= size;
        block.roots = {};
      }
      return true;
    });
    if (complete) {
      std::sort(blocks_.begin(), blocks_.end(), [](const Block& a, const Block& b) {
        return std::make_pair(-a.best_bound, a.first_rotation) < std::make_pair(-b.best_bound, b.first_rotation);
      });
    }
    outcome_.root_time += watch.lap();
    return complete;
  }

  /// Searches below all initial nodes that may hold the quarry. `unsearched` becomes a bound for what the deadline
  /// left.
  bool hunt(Quarry& quarry, std::int32_t& unsearched) {
    Stopwatch watch;
    std::atomic<std::int32_t> bound{0};
    const bool complete = forEachBlock([&](BlockSearch& search, Block& block) {
      if (block.best_bound < quarry.threshold()) {
        return true;
      }
      if (block.stored) {
        return searchBelow(search, block, quarry, bound);
      }
      Block again;
      again.first_rotation = block.first_rotation;
      if (search.scoreRoots(again, quarry.threshold())) {
        return searchBelow(search, again, quarry, bound);
      }
      raise(bound, block.best_bound);
      return false;
    });
    // The blocks are sorted: none that was not begun has a higher bound than one that was not finished.
    unsearched = bound;
    outcome_.below_time += watch.lap();
    return complete;
  }

  static bool searchBelow(BlockSearch& search, const Block& block, Quarry& quarry,
                          std::atomic<std::int32_t>& unsearched) {
    if (search.searchBelow(block, quarry)) {
      return true;
    }
    raise(unsearched, search.unsearchedBound());
    return false;
  }

  static void raise(std::atomic<std::int32_t>& value, std::int32_t to) {
    std::int32_t old = value;
    while (old < to && !value.compare_exchange_weak(old, to)) {
    }
  }

  void findBest() {
    const bool known = problem_.known_count >= problem_.min_count;
    const std::int32_t threshold = std::max({1, problem_.min_count, problem_.known_count});
    // Where a pose is known, the initial nodes serve the search for the runner-up as well.
    if (!scoreRoots(known ? std::min(threshold, runnerUpThreshold(threshold)) : threshold)) {
      return;
    }
    Quarry quarry(threshold);
    std::int32_t unsearched = 0;
    outcome_.best_proven = hunt(quarry, unsearched);
    outcome_.best = quarry.best();
    outcome_.upper_bound = std::max(outcome_.best ? outcome_.best->count : threshold - 1, unsearched);
  }

  void findRunnerUp() {
    const std::int32_t threshold = runnerUpThreshold(outcome_.best->count);
    if (threshold < root_threshold_ && !scoreRoots(threshold)) {
      return;
    }
    Quarry quarry(threshold, Surroundings(*outcome_.best, problem_));
    std::int32_t unsearched = 0;
    outcome_.runner_up_proven = hunt(quarry, unsearched);
    outcome_.runner_up = quarry.best();
    outcome_.runner_up_bound = std::max(outcome_.runner_up ? outcome_.runner_up->count : threshold - 1, unsearched);
  }

  const ExactProblem& problem_;
  const ExactSettings& settings_;
  std::vector<BlockSearch> searches_;
  std::vector<Block> blocks_;
  std::int32_t root_threshold_ = 0;  // that the initial nodes at hand reach
  ExactOutcome outcome_;
};

}  // namespace

ExactOutcome exactSearch(const ExactProblem& problem, const ExactSettings& settings) {
  return ExactSearch(problem, settings).run();
}

}  // namespace map_matcher
