#include "block_search.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace map_matcher::search {
namespace {

/// Levels that one expansion goes down, at most 3, so that the children fit into a tile.
constexpr int kLevelsAtOnce = 1;

/// The window with its first translation on the grain of a level.
SearchWindow onGrain(const SearchWindow& window, const BlockShape& shape) {
  const int mask = ~(shape.grain() - 1);
  return {{window.first.x & mask, window.first.y & mask}, window.last};
}

}  // namespace

/// Scores the initial nodes of a block and keeps those that reach `min_count`, the best first. False when the
/// deadline passed before that.
bool BlockSearch::scoreRoots(RotationBlock& block, std::int32_t min_count) {
  block.roots.clear();
  enter(block);
  const BlockShape shape{levels_.sieve};
  const SearchWindow reachable =
      reachableWindow(problem_.reference, shape, cellsOf(shape, block.first_rotation), min_count);
  const SearchWindow window = onGrain(intersection(windowOf(block.first_rotation, shape), reachable), shape);
  const bool complete = levels_.sieve > levels_.nodes
                            ? scoreWhereAnythingIs(block.first_rotation, window, min_count, block.roots)
                            : scoreWindow(block.first_rotation, window, min_count, block.roots);
  if (!complete) {
    return false;
  }
  std::sort(block.roots.begin(), block.roots.end(), [](const RootNode& a, const RootNode& b) {
    return std::make_tuple(-a.bound, a.rotation, a.first.y, a.first.x) <
           std::make_tuple(-b.bound, b.rotation, b.first.y, b.first.x);
  });
  block.best_bound = block.roots.empty() ? 0 : block.roots.front().bound;
  return true;
}

/// Adds the initial nodes of a window that reach `min_count`. False when the deadline passed before that.
bool BlockSearch::scoreWindow(int rotation, const SearchWindow& window, std::int32_t min_count,
                              std::vector<RootNode>& roots) {
  const BlockShape shape{levels_.nodes};
  const int stride = shape.stride();
  for (int y = window.first.y; y <= window.last.y; y += stride * kTileRows) {
    for (int x = window.first.x; x <= window.last.x; x += stride * kTileColumns) {
      if (!scoreTile(shape, rotation, {x, y}, tileWithin(window.last, {x, y}, stride), min_count)) {
        return false;
      }
      for (const TileScore& score : scores_) {
        roots.push_back({score.count, rotation, {x + score.column * stride, y + score.row * stride}});
      }
    }
  }
  return true;
}

/// The same for both halves of a block, but looks only at tiles that hold a node of the sieve's level which reaches
/// `min_count`.
bool BlockSearch::scoreWhereAnythingIs(int first_rotation, const SearchWindow& window, std::int32_t min_count,
                                       std::vector<RootNode>& roots) {
  const BlockShape shape{levels_.sieve};
  const BlockShape half{levels_.nodes};
  const int stride = shape.stride();
  const grid::Cell tile{kTileColumns * half.stride(), kTileRows * half.stride()};  // of initial nodes [cells]
  for (int y = window.first.y; y <= window.last.y; y += stride * kTileRows) {
    for (int x = window.first.x; x <= window.last.x; x += stride * kTileColumns) {
      if (!scoreTile(shape, first_rotation, {x, y}, tileWithin(window.last, {x, y}, stride), min_count)) {
        return false;
      }
      std::array<bool, 4> anything{};
      for (const TileScore& score : scores_) {
        anything[static_cast<std::size_t>(score.row * 2 / kTileRows * 2 + score.column * 2 / kTileColumns)] = true;
      }
      for (int k = 0; k < 8; ++k) {
        const grid::Cell part{x + k % 2 * tile.x, y + k / 2 % 2 * tile.y};
        const int rotation = first_rotation + k / 4 * half.stride();
        const SearchWindow here = intersection(intersection({part, {part.x + tile.x - 1, part.y + tile.y - 1}}, window),
                                               windowOf(rotation, half));
        if (anything[static_cast<std::size_t>(k % 4)] && rotation < problem_.rotations.count() &&
            !scoreWindow(rotation, onGrain(here, half), min_count, roots)) {
          return false;
        }
      }
    }
  }
  return true;
}

/// Scores a tile of nodes. False when the deadline passed before that.
bool BlockSearch::scoreTile(const BlockShape& shape, int rotation, const grid::Cell& first, const TileSize& size,
                            std::int32_t min_count) {
  if (settings_.deadline.passed()) {
    return false;
  }
  nodes_scored_ += static_cast<std::int64_t>(size.columns) * size.rows;
  settings_.kernel.scoreTile(problem_.reference.level(shape.level), cellsOf(shape, rotation),
                             problem_.reference.position(shape.level, first), size, min_count, scores_);
  return true;
}

/// Forgets the cells of another block.
void BlockSearch::enter(const RotationBlock& block) {
  block_cells_.assign(static_cast<std::size_t>(2 << levels_.sieve), std::nullopt);
  first_rotation_ = block.first_rotation;
}

std::int32_t BlockSearch::searchBelow(const RotationBlock& block, Incumbent& incumbent) {
  enter(block);
  for (std::size_t k = 0; k < block.roots.size() && block.roots[k].bound >= incumbent.threshold(); ++k) {
    const std::int32_t rest = searchBelow(nodeOf(block.roots[k]), incumbent);
    if (rest > 0) {
      return std::max(rest, boundOf(block, incumbent, k + 1));
    }
  }
  return 0;
}

std::int32_t BlockSearch::boundOf(const RotationBlock& block, const Incumbent& incumbent, std::size_t first) const {
  const auto promising = std::find_if(block.roots.begin() + static_cast<std::ptrdiff_t>(first), block.roots.end(),
                                      [&](const RootNode& root) { return !incumbent.prunes(nodeOf(root)); });
  return promising == block.roots.end() ? 0 : promising->bound;  // the best first
}

/// Translations that any rotation of the node may have.
SearchWindow BlockSearch::windowOf(int first_rotation, const BlockShape& shape) const {
  if (problem_.windows.empty()) {
    return everywhere();
  }
  SearchWindow window{everywhere().last, everywhere().first};
  const int end = std::min(problem_.rotations.count(), first_rotation + shape.stride());
  for (int n = first_rotation; n < end; ++n) {
    window = hull(window, problem_.windows[static_cast<std::size_t>(n)]);
  }
  return window;
}

/// Depth first, the best child first. Bound of what the deadline left, 0 for nothing.
std::int32_t BlockSearch::searchBelow(const SearchNode& root, Incumbent& incumbent) {
  nodes_.assign(1, root);
  while (!nodes_.empty()) {
    const SearchNode node = nodes_.back();
    nodes_.pop_back();
    if (incumbent.prunes(node)) {
      continue;
    }
    if (node.level == 0) {
      incumbent.offer({node.rotation, node.first, node.bound});
      continue;
    }
    if (settings_.deadline.passed()) {
      nodes_.push_back(node);
      return boundOfRest(incumbent);
    }
    expand(node, incumbent.threshold());
  }
  return 0;
}

/// Bound of the nodes at hand that the incumbent does not prune, 0 for none.
std::int32_t BlockSearch::boundOfRest(const Incumbent& incumbent) const {
  std::int32_t bound = 0;
  for (const SearchNode& node : nodes_) {
    bound = incumbent.prunes(node) ? bound : std::max(bound, node.bound);
  }
  return bound;
}

/// Adds the nodes kLevelsAtOnce levels below that reach `min_count`, the best last.
void BlockSearch::expand(const SearchNode& node, std::int32_t min_count) {
  ++nodes_expanded_;
  const BlockShape shape{std::max(0, node.level - kLevelsAtOnce)};
  const int end = std::min(problem_.rotations.count(), node.rotation + (1 << node.level));
  const auto first_child = static_cast<std::ptrdiff_t>(nodes_.size());
  for (int rotation = node.rotation; rotation < end; rotation += shape.stride()) {
    addChildren(node, shape, rotation, min_count);
  }
  std::sort(nodes_.begin() + first_child, nodes_.end(), [](const SearchNode& a, const SearchNode& b) {
    return std::make_tuple(-a.bound, a.rotation, a.first.y, a.first.x) >
           std::make_tuple(-b.bound, b.rotation, b.first.y, b.first.x);
  });
}

/// Adds those of the node's children under a rotation that reach `min_count`.
void BlockSearch::addChildren(const SearchNode& node, const BlockShape& shape, int rotation, std::int32_t min_count) {
  const int children = 1 << (node.level - shape.level);  // along an axis
  nodes_scored_ += children * children;
  settings_.kernel.scoreTile(problem_.reference.level(shape.level), cellsOf(shape, rotation),
                             problem_.reference.position(shape.level, node.first), {children, children}, min_count,
                             scores_);
  const SearchWindow window = windowOf(rotation, shape);
  for (const TileScore& score : scores_) {
    const grid::Cell child{node.first.x + score.column * shape.stride(), node.first.y + score.row * shape.stride()};
    const bool inside = child.x <= window.last.x && child.y <= window.last.y &&
                        child.x + shape.stride() > window.first.x && child.y + shape.stride() > window.first.y;
    if (inside) {
      nodes_.push_back({score.count, rotation, child, shape.level});
    }
  }
}

/// The cells of a node below the current block, kept until the next block.
const WeightedCells& BlockSearch::cellsOf(const BlockShape& shape, int rotation) {
  const int blocks_above = 1 << (levels_.sieve - shape.level);  // a binary tree, level by level
  const int index = blocks_above + ((rotation - first_rotation_) >> shape.level);
  std::optional<WeightedCells>& cells = block_cells_[static_cast<std::size_t>(index)];
  if (!cells) {
    cells = problem_.rotations.cells(shape, rotation);
  }
  return *cells;
}

}  // namespace map_matcher::search
