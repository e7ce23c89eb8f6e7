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

class DepthFirstSearch {
 public:
  DepthFirstSearch(const SearchProblem& problem, const StopToken& stop)
      : problem_(problem), stop_(stop), threshold_(std::max(1, problem.min_count)) {}

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
    outcome_.stopped = outcome_.stopped || stop_.stopRequested();
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
    const SearchWindow window =
        intersection(problem_.windows[n], reachableWindow(problem_.reference, problem_.rotations[n], threshold_));
    if (window.empty()) {
      return;
    }
    const int stride = 1 << problem_.root_level;
    const bool narrow = (window.last.x - window.first.x) / stride < tileColumns(TileShape::kNarrow);
    const TileShape shape = narrow ? TileShape::kNarrow : TileShape::kWide;
    for (int y = window.first.y; y <= window.last.y; y += stride * tileRows(shape)) {
      for (int x = window.first.x; x <= window.last.x && !checkStop(); x += stride * tileColumns(shape)) {
        scoreTile(shape, rotation, {x, y}, window.last);
      }
    }
  }

  void scoreTile(TileShape shape, std::int32_t rotation, const Cell& first, const Cell& last) {
    const PooledLevel& level = problem_.reference.level(problem_.root_level);
    const RotatedCells& cells = problem_.rotations[static_cast<std::size_t>(rotation)];
    const int stride = level.stride();
    const int columns = std::min(tileColumns(shape), (last.x - first.x) / stride + 1);
    const int rows = std::min(tileRows(shape), (last.y - first.y) / stride + 1);
    outcome_.nodes_scored += static_cast<std::int64_t>(columns) * rows;
    if (!kernel_.scoreTile(shape, level, cells, first, threshold_, tile_)) {
      return;
    }
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const std::int32_t count = tile_[static_cast<std::size_t>(row * tileColumns(shape) + column)];
        if (count >= threshold_) {
          const Cell translation{first.x + column * stride, first.y + row * stride};
          initial_nodes_.push_back({count, rank(rotation), rotation, translation, problem_.root_level});
        }
      }
    }
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

  // Lines 20 to 25. The best child is searched first, hence pushed last.
  void expand(const Node& node) {
    ++outcome_.nodes_expanded;
    outcome_.nodes_scored += 4;
    const PooledLevel& level = problem_.reference.level(node.level - 1);
    const RotatedCells& cells = problem_.rotations[static_cast<std::size_t>(node.rotation)];
    std::array<std::int32_t, 4> counts;
    if (!kernel_.scoreChildren(level, cells, node.first, threshold_, counts)) {
      return;
    }
    const Cell& last = problem_.windows[static_cast<std::size_t>(node.rotation)].last;
    const auto first_child = static_cast<std::ptrdiff_t>(nodes_.size());
    for (int k = 0; k < 4; ++k) {
      const Cell first{node.first.x + (k & 1) * level.stride(), node.first.y + (k >> 1) * level.stride()};
      const std::int32_t count = counts[static_cast<std::size_t>(k)];
      if (count >= threshold_ && first.x <= last.x && first.y <= last.y) {
        nodes_.push_back({count, node.rank, node.rotation, first, node.level - 1});
      }
    }
    std::sort(nodes_.begin() + first_child, nodes_.end(), searchedAfter);
  }

  const SearchProblem& problem_;
  const StopToken& stop_;
  std::int32_t threshold_;  // line 5
  SearchOutcome outcome_;
  std::vector<Node> initial_nodes_;
  std::vector<Node> nodes_;
  ScoreKernel kernel_;
  TileCounts tile_;
  std::int32_t best_initial_count_ = 0;
};

}  // namespace

SearchOutcome branchAndBound(const SearchProblem& problem, const StopToken& stop) {
  return DepthFirstSearch(problem, stop).run();
}

}  // namespace map_matcher
