#include "block_search.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace map_matcher {

/// Scores the initial nodes of a block and keeps those that reach `min_count`, the best first. False when the
/// deadline passed before that.
bool BlockSearch::scoreRoots(RotationBlock& block, std::int32_t min_count) {
  block.roots.clear();
  const BlockShape shape{root_level_};
  const WeightedCells cells = problem_.rotations.cells(shape, block.first_rotation, merger_);
  const SearchWindow window =
      intersection(windowOf(block.first_rotation, shape), reachableWindow(problem_.reference, shape, cells, min_count));
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
  std::sort(block.roots.begin(), block.roots.end(), [](const RootNode& a, const RootNode& b) {
    return std::make_tuple(-a.bound, a.first.y, a.first.x) < std::make_tuple(-b.bound, b.first.y, b.first.x);
  });
  block.best_bound = block.roots.empty() ? 0 : block.roots.front().bound;
  return true;
}

/// Searches below the initial nodes of a block. False when the deadline passed before that.
bool BlockSearch::searchBelow(const RotationBlock& block, Quarry& quarry) {
  block_cells_.assign(static_cast<std::size_t>(2 << root_level_), std::nullopt);
  first_rotation_ = block.first_rotation;
  for (const RootNode& root : block.roots) {
    if (root.bound < quarry.threshold()) {
      break;
    }
    if (!searchBelow(ExactNode{root.bound, block.first_rotation, root.first, root_level_}, quarry)) {
      unsearched_bound_ = root.bound;
      return false;
    }
  }
  return true;
}

/// Translations that any rotation of the node may have.
SearchWindow BlockSearch::windowOf(int first_rotation, const BlockShape& shape) const {
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

void BlockSearch::scoreTile(TileShape tile, const WeightedCells& cells, const Cell& first, const Cell& last,
                            std::int32_t min_count, std::vector<RootNode>& roots) {
  const PooledLevel& level = problem_.reference.level(root_level_);
  const int shift = problem_.reference.shift(root_level_);
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
bool BlockSearch::searchBelow(const ExactNode& root, Quarry& quarry) {
  nodes_.assign(1, root);
  while (!nodes_.empty()) {
    const ExactNode node = nodes_.back();
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
void BlockSearch::expand(const ExactNode& node, std::int32_t min_count) {
  ++nodes_expanded_;
  const BlockShape shape{node.level - 1};
  const auto first_child = static_cast<std::ptrdiff_t>(nodes_.size());
  for (int half = 0; half < 2; ++half) {
    const int rotation = node.rotation + half * shape.stride();
    if (rotation < problem_.rotations.count()) {
      addChildren({0, rotation, node.first, shape.level}, min_count);
    }
  }
  std::sort(nodes_.begin() + first_child, nodes_.end(), [](const ExactNode& a, const ExactNode& b) {
    return std::make_tuple(-a.bound, a.rotation, a.first.y, a.first.x) >
           std::make_tuple(-b.bound, b.rotation, b.first.y, b.first.x);
  });
}

/// Adds the child `lower_left` and those one stride beside it that reach `min_count`.
void BlockSearch::addChildren(const ExactNode& lower_left, std::int32_t min_count) {
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
const WeightedCells& BlockSearch::cellsOf(const BlockShape& shape, int rotation) {
  const int blocks_above = 1 << (root_level_ - shape.level);  // a binary tree, level by level
  const int index = blocks_above + ((rotation - first_rotation_) >> shape.level);
  std::optional<WeightedCells>& cells = block_cells_[static_cast<std::size_t>(index)];
  if (!cells) {
    cells = problem_.rotations.cells(shape, rotation, merger_);
  }
  return *cells;
}

}  // namespace map_matcher
