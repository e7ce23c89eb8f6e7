#include "block_search.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

namespace map_matcher::search {
namespace {

/// Nodes along either axis of the part of a map whose nodes are expanded at once: their children are one tile.
constexpr int kGroupColumns = kTileColumns / 2;
constexpr int kGroupRows = kTileRows / 2;

/// The window with its first translation on the stride of a level, so that nodes lie side by side in groups.
SearchWindow onStride(const SearchWindow& window, const BlockShape& shape) {
  const int mask = ~(shape.stride() - 1);
  return {{window.first.x & mask, window.first.y & mask}, window.last};
}

/// The first translation of the group that a node belongs to.
grid::Cell groupOf(const SearchNode& node) {
  return {node.first.x & -(kGroupColumns << node.level), node.first.y & -(kGroupRows << node.level)};
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
  const SearchWindow window = onStride(intersection(windowOf(block.first_rotation, shape), reachable), shape);
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
      addRoots(rotation, {x, y}, roots);
    }
  }
  return true;
}

/// The same for both halves of a block, but looks only at nodes below those of the sieve's level that reach
/// `min_count`.
bool BlockSearch::scoreWhereAnythingIs(int first_rotation, const SearchWindow& window, std::int32_t min_count,
                                       std::vector<RootNode>& roots) {
  const BlockShape shape{levels_.sieve};
  const BlockShape half{levels_.nodes};
  const int stride = shape.stride();
  for (int y = window.first.y; y <= window.last.y; y += stride * kTileRows) {
    for (int x = window.first.x; x <= window.last.x; x += stride * kTileColumns) {
      if (!scoreTile(shape, first_rotation, {x, y}, tileWithin(window.last, {x, y}, stride), min_count)) {
        return false;
      }
      const std::vector<TileScore> promising = scores_;
      for (int k = 0; k < 2; ++k) {
        const int rotation = first_rotation + k * half.stride();
        if (rotation < problem_.rotations.count() && !promising.empty() &&
            !scoreBelow(promising, {x, y}, rotation, intersection(window, windowOf(rotation, half)), min_count,
                        roots)) {
          return false;
        }
      }
    }
  }
  return true;
}

/// Adds the initial nodes in a window below nodes of a tile of the sieve's level that begins at `first`.
bool BlockSearch::scoreBelow(const std::vector<TileScore>& promising, const grid::Cell& first, int rotation,
                             const SearchWindow& window, std::int32_t min_count, std::vector<RootNode>& roots) {
  const BlockShape half{levels_.nodes};
  const int stride = half.stride();
  std::array<TileMask, 4> wanted{};  // of the tiles in the quarters of that of the sieve
  for (const TileScore& node : promising) {
    for (int k = 0; k < 4; ++k) {
      const int column = 2 * node.column + k % 2;
      const int row = 2 * node.row + k / 2;
      const grid::Cell child{first.x + column * stride, first.y + row * stride};
      if (child.x <= window.last.x && child.y <= window.last.y && child.x + stride > window.first.x &&
          child.y + stride > window.first.y) {
        TileWord& word = wanted[static_cast<std::size_t>(row / kTileRows * 2 + column / kTileColumns)]
                               [static_cast<std::size_t>(column % kTileColumns)];
        word = static_cast<TileWord>(word | 1 << row % kTileRows);
        ++nodes_scored_;
      }
    }
  }
  for (int k = 0; k < 4; ++k) {
    const TileMask& mask = wanted[static_cast<std::size_t>(k)];
    if (std::all_of(mask.begin(), mask.end(), [](TileWord word) { return word == 0; })) {
      continue;
    }
    if (settings_.deadline.passed()) {
      return false;
    }
    const grid::Cell tile{first.x + k % 2 * kTileColumns * stride, first.y + k / 2 * kTileRows * stride};
    settings_.kernel.scorePart(problem_.reference.level(half.level), cellsOf(half, rotation),
                               problem_.reference.position(half.level, tile), mask, min_count, scores_);
    addRoots(rotation, tile, roots);
  }
  return true;
}

/// Adds what reached the count in a tile of initial nodes.
void BlockSearch::addRoots(int rotation, const grid::Cell& tile, std::vector<RootNode>& roots) const {
  const int stride = BlockShape{levels_.nodes}.stride();
  for (const TileScore& score : scores_) {
    roots.push_back({score.count, rotation, {tile.x + score.column * stride, tile.y + score.row * stride}});
  }
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

/// Depth first, the best group of nodes first.
std::int32_t BlockSearch::searchBelow(const RotationBlock& block, Incumbent& incumbent) {
  enter(block);
  groups_.clear();
  std::vector<SearchNode> nodes;
  for (const RootNode& root : block.roots) {
    if (root.bound < incumbent.threshold()) {  // the best first
      break;
    }
    nodes.push_back(nodeOf(root));
  }
  addGroups(nodes);
  while (!groups_.empty()) {
    NodeGroup group = std::move(groups_.back());
    groups_.pop_back();
    group.nodes.erase(std::remove_if(group.nodes.begin(), group.nodes.end(),
                                     [&](const SearchNode& node) { return incumbent.prunes(node); }),
                      group.nodes.end());
    if (group.nodes.empty()) {
      continue;
    }
    if (group.nodes.front().level == 0) {
      offer(group.nodes, incumbent);
    } else if (settings_.deadline.passed()) {
      groups_.push_back(std::move(group));
      return boundOfRest(incumbent);
    } else {
      expand(group, incumbent);
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

/// Bound of the nodes at hand that the incumbent does not prune, 0 for none.
std::int32_t BlockSearch::boundOfRest(const Incumbent& incumbent) const {
  std::int32_t bound = 0;
  for (const NodeGroup& group : groups_) {
    for (const SearchNode& node : group.nodes) {
      bound = incumbent.prunes(node) ? bound : std::max(bound, node.bound);
    }
  }
  return bound;
}

void BlockSearch::offer(const std::vector<SearchNode>& poses, Incumbent& incumbent) {
  for (const SearchNode& pose : poses) {
    if (!incumbent.prunes(pose)) {
      incumbent.offer({pose.rotation, pose.first, pose.bound});
    }
  }
}

/// Adds the groups of some nodes of a level, the best last.
void BlockSearch::addGroups(std::vector<SearchNode>& nodes) {
  const auto place_of = [](const SearchNode& node) {
    const grid::Cell first = groupOf(node);
    return std::make_tuple(node.rotation, first.y, first.x);
  };
  std::sort(nodes.begin(), nodes.end(), [&](const SearchNode& a, const SearchNode& b) {
    return std::make_tuple(place_of(a), -a.bound, a.first.y, a.first.x) <
           std::make_tuple(place_of(b), -b.bound, b.first.y, b.first.x);
  });
  const auto first_group = static_cast<std::ptrdiff_t>(groups_.size());
  for (auto first = nodes.cbegin(); first != nodes.cend();) {
    const auto end =
        std::find_if(first, nodes.cend(), [&](const SearchNode& node) { return place_of(node) != place_of(*first); });
    groups_.push_back({{first, end}});
    first = end;
  }
  std::stable_sort(groups_.begin() + first_group, groups_.end(), [](const NodeGroup& a, const NodeGroup& b) {
    return a.nodes.front().bound < b.nodes.front().bound;
  });
}

/// Adds the children of a group's nodes that the incumbent does not prune. Counting a tile of them takes as long as
/// counting those of one node.
void BlockSearch::expand(const NodeGroup& group, Incumbent& incumbent) {
  const SearchNode& node = group.nodes.front();
  const BlockShape shape{node.level - 1};
  const grid::Cell first = groupOf(node);
  TileMask children{};
  for (const SearchNode& parent : group.nodes) {
    const auto column = static_cast<std::size_t>((parent.first.x - first.x) >> shape.level);
    const int row = (parent.first.y - first.y) >> shape.level;
    children[column] = static_cast<TileWord>(children[column] | 3 << row);
    children[column + 1] = static_cast<TileWord>(children[column + 1] | 3 << row);
  }
  nodes_expanded_ += static_cast<std::int64_t>(group.nodes.size());
  const int end = std::min(problem_.rotations.count(), node.rotation + (1 << node.level));
  children_.clear();
  for (int rotation = node.rotation; rotation < end; rotation += shape.stride()) {
    nodes_scored_ += 4 * static_cast<std::int64_t>(group.nodes.size());
    settings_.kernel.scorePart(problem_.reference.level(shape.level), cellsOf(shape, rotation),
                               problem_.reference.position(shape.level, first), children, incumbent.threshold(),
                               scores_);
    addChildren(shape, rotation, first, incumbent);
  }
  addGroups(children_);
}

/// Takes those nodes of the last tile that lie in the window of their rotation and that the incumbent does not prune.
void BlockSearch::addChildren(const BlockShape& shape, int rotation, const grid::Cell& first,
                              const Incumbent& incumbent) {
  const SearchWindow window = windowOf(rotation, shape);
  for (const TileScore& score : scores_) {
    const SearchNode child{score.count,
                           rotation,
                           {first.x + score.column * shape.stride(), first.y + score.row * shape.stride()},
                           shape.level};
    const bool inside = child.first.x <= window.last.x && child.first.y <= window.last.y &&
                        child.first.x + shape.stride() > window.first.x &&
                        child.first.y + shape.stride() > window.first.y;
    if (inside && !incumbent.prunes(child)) {
      children_.push_back(child);
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
