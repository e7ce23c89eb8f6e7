#include "map_matcher/search/branch_and_bound.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "map_matcher/search/score_kernel.hpp"
#include "map_matcher/search/stopwatch.hpp"

namespace map_matcher {
namespace {

/// All translations first + [0, 2^level) x [0, 2^level) under one rotation.
struct Node {
  std::int32_t count;  // matched cells at most, in integers: an upper bound for all that the node stands for
  std::int32_t rank;   // of its rotation in the initial list
  std::int32_t rotation;
  Cell first;
  std::int32_t level;
};

/// Whether `a` is searched after `b`. Total, so that every run searches in the same order.
bool searchedAfter(const Node& a, const Node& b) {
  return std::make_tuple(-a.rank, a.count, -a.rotation, -a.first.y, -a.first.x) <
         std::make_tuple(-b.rank, b.count, -b.rotation, -b.first.y, -b.first.x);
}

/// Levels that one expansion goes down: counting the 16 children of two levels takes as long as the 4 of one.
constexpr int kLevelsAtOnce = 2;

/// Levels above the initial nodes at which empty parts of a map are passed over.
constexpr int kSieveLevels = 2;

/// Tiles of a window that are scored without a look at which of them can hold anything.
constexpr std::int64_t kFewTiles = 24;

class DepthFirstSearch {
 public:
  DepthFirstSearch(const SearchProblem& problem, const Deadline& deadline)
      : problem_(problem), deadline_(deadline), threshold_(std::max(1, problem.min_count)) {}

  SearchOutcome run() {
    Stopwatch watch;
    scoreInitialNodes();
    outcome_.rotation_expansion_time = watch.lap();
    dropHopelessNodes();
    std::sort(initial_nodes_.begin(), initial_nodes_.end(), searchedAfter);
    while (!initial_nodes_.empty() && !outcome_.stopped) {
      const Node root = initial_nodes_.back();
      initial_nodes_.pop_back();
      searchBelow(root);
    }
    outcome_.depth_first_search_time = watch.lap();
    return outcome_;
  }

 private:
  bool checkStop() {
    outcome_.stopped = outcome_.stopped || deadline_.passed();
    return outcome_.stopped;
  }

  // Lines 4 to 10: all rotations at the root level, all translations on its stride.
  void scoreInitialNodes() {
    for (std::size_t n = 0; n < problem_.rotations.size() && !checkStop(); ++n) {
      const auto first_new = static_cast<std::ptrdiff_t>(initial_nodes_.size());
      scoreRotation(static_cast<std::int32_t>(n));
      searchBestOf(first_new);
    }
  }

  // Goes down at once below the best new initial node if it is the best so far: a high threshold early on keeps most
  // nodes out of the list. The answer stays the same; the report sorts the complete list first.
  void searchBestOf(std::ptrdiff_t first_new) {
    const auto best = std::max_element(initial_nodes_.begin() + first_new, initial_nodes_.end(), searchedAfter);
    if (best == initial_nodes_.end() || best->count <= best_initial_count_) {
      return;
    }
    const Node node = *best;
    best_initial_count_ = node.count;
    initial_nodes_.erase(best);
    searchBelow(node);
  }

  void scoreRotation(std::int32_t rotation) {
    const auto n = static_cast<std::size_t>(rotation);
    const int stride = 1 << problem_.root_level;
    SearchWindow window = problem_.windows[n];
    if (!window.empty() && numTiles(window, stride) > kFewTiles) {  // else counting takes no longer than a look
      window = intersection(window, reachableWindow(problem_.reference, problem_.rotations[n], threshold_));
    }
    if (window.empty()) {
      return;
    }
    const int sieve = std::min(problem_.root_level + kSieveLevels, problem_.reference.topLevel());
    if (sieve > problem_.root_level && numTiles(window, stride) > kFewTiles) {
      scoreWhereAnythingIs(rotation, window, sieve);
    } else {
      scoreWindow(rotation, window);
    }
  }

  /// Tiles of nodes with a stride that a window takes.
  static std::int64_t numTiles(const SearchWindow& window, int stride) {
    const std::int64_t columns = (window.last.x - window.first.x) / (stride * kTileColumns) + 1;
    const std::int64_t rows = (window.last.y - window.first.y) / (stride * kTileRows) + 1;
    return columns * rows;
  }

  /// Adds the initial nodes of a window that reach the threshold to the list.
  void scoreWindow(std::int32_t rotation, const SearchWindow& window) {
    const int stride = 1 << problem_.root_level;
    for (int y = window.first.y; y <= window.last.y; y += stride * kTileRows) {
      for (int x = window.first.x; x <= window.last.x && !checkStop(); x += stride * kTileColumns) {
        scoreTile(problem_.root_level, rotation, {x, y}, tileWithin(window.last, {x, y}, stride));
        for (const TileScore& score : scores_) {
          const Cell translation{x + score.column * stride, y + score.row * stride};
          initial_nodes_.push_back({score.count, rank(rotation), rotation, translation, problem_.root_level});
        }
      }
    }
  }

  /// The same, but looks only at tiles that hold a node of the level `sieve` which reaches the threshold: most of a
  /// large map is empty.
  void scoreWhereAnythingIs(std::int32_t rotation, const SearchWindow& window, int sieve) {
    const int stride = 1 << sieve;
    const int finer = 1 << (sieve - problem_.root_level);
    const Cell tile{kTileColumns * stride / finer, kTileRows * stride / finer};  // of initial nodes
    for (int y = window.first.y; y <= window.last.y; y += stride * kTileRows) {
      for (int x = window.first.x; x <= window.last.x && !checkStop(); x += stride * kTileColumns) {
        scoreTile(sieve, rotation, {x, y}, tileWithin(window.last, {x, y}, stride));
        std::array<bool, 1 << (2 * kSieveLevels)> anything{};
        for (const TileScore& score : scores_) {
          const int column = score.column * finer / kTileColumns;
          const int row = score.row * finer / kTileRows;
          anything[static_cast<std::size_t>(row * finer + column)] = true;
        }
        for (int k = 0; k < finer * finer; ++k) {
          if (anything[static_cast<std::size_t>(k)]) {
            const Cell first{x + k % finer * tile.x, y + k / finer * tile.y};
            scoreWindow(rotation, intersection({first, {first.x + tile.x - 1, first.y + tile.y - 1}}, window));
          }
        }
      }
    }
  }

  /// Scores a tile of nodes of a level.
  void scoreTile(int level, std::int32_t rotation, const Cell& first, const TileSize& size) {
    outcome_.nodes_scored += static_cast<std::int64_t>(size.columns) * size.rows;
    const RotatedCells& cells = problem_.rotations[static_cast<std::size_t>(rotation)];
    kernel_.scoreTile(problem_.reference.level(level), cells, first, size, threshold_, scores_);
  }

  void dropHopelessNodes() {
    const auto hopeless = [this](const Node& node) { return node.count < threshold_; };
    initial_nodes_.erase(std::remove_if(initial_nodes_.begin(), initial_nodes_.end(), hopeless), initial_nodes_.end());
  }

  std::int32_t rank(std::int32_t rotation) const {
    return problem_.order.empty() ? 0 : problem_.order[static_cast<std::size_t>(rotation)];
  }

  // Lines 12 to 27 for one initial node.
  void searchBelow(const Node& root) {
    nodes_.assign(1, root);
    while (!nodes_.empty()) {
      const Node node = nodes_.back();
      nodes_.pop_back();
      if (node.count < threshold_) {  // line 14
        continue;
      }
      if (node.level == 0) {  // lines 17 to 19
        accept(node);
      } else {
        expand(node);
      }
      if (checkStop()) {
        return;
      }
    }
  }

  void accept(const Node& leaf) {
    outcome_.best = SearchPose{leaf.rotation, leaf.first, leaf.count};
    threshold_ = leaf.count + 1;  // only better ones from here on
  }

  // Lines 20 to 25, kLevelsAtOnce levels at once. The best child is searched first, hence pushed last.
  void expand(const Node& node) {
    ++outcome_.nodes_expanded;
    const int level = std::max(0, node.level - kLevelsAtOnce);
    const int stride = 1 << level;
    const int children = 1 << (node.level - level);  // along an axis
    TileSize size = tileWithin(problem_.windows[static_cast<std::size_t>(node.rotation)].last, node.first, stride);
    size = {std::min(size.columns, children), std::min(size.rows, children)};
    scoreTile(level, node.rotation, node.first, size);
    const auto first_child = static_cast<std::ptrdiff_t>(nodes_.size());
    for (const TileScore& score : scores_) {
      const Cell first{node.first.x + score.column * stride, node.first.y + score.row * stride};
      nodes_.push_back({score.count, node.rank, node.rotation, first, level});
    }
    std::sort(nodes_.begin() + first_child, nodes_.end(), searchedAfter);
  }

  const SearchProblem& problem_;
  const Deadline& deadline_;
  std::int32_t threshold_;  // line 5
  SearchOutcome outcome_;
  std::vector<Node> initial_nodes_;
  std::vector<Node> nodes_;
  ScoreKernel kernel_;
  std::vector<TileScore> scores_;  // of the last tile
  std::int32_t best_initial_count_ = 0;
};

}  // namespace

SearchOutcome branchAndBound(const SearchProblem& problem, const Deadline& deadline) {
  return DepthFirstSearch(problem, deadline).run();
}

}  // namespace map_matcher
