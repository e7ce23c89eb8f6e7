/// \file
/// The part of an exact search that one thread does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "incumbent.hpp"
#include "map_matcher/search/exact/exact_search.hpp"

namespace map_matcher::search {

/// Where a search begins.
struct RootLevels {
  int nodes = 0;  ///< Level of the initial nodes.
  int sieve = 0;  ///< Level of the nodes that tell in which parts of the map there may be any: `nodes`, which then tell
                  ///< it themselves, or one more. A block has 2^sieve rotations.
};

/// An initial node of a block of rotations.
struct RootNode {
  std::int32_t bound;
  int rotation;
  grid::Cell first;
};

/// The initial nodes of a block of rotations.
struct RotationBlock {
  int first_rotation = 0;
  bool stored = false;  // whether `roots` holds its nodes, the best first
  std::int32_t best_bound = 0;
  std::vector<RootNode> roots;
  std::optional<std::int32_t> rest;  // bound of what a search below them left, 0 for nothing; none: it was not begun
};

/// Nodes of a level and a rotation, of a part of the map whose nodes are expanded at once; the best first.
struct NodeGroup {
  std::vector<SearchNode> nodes;
};

/// Work of one thread: scores initial nodes and searches below them, block by block.
class BlockSearch {
 public:
  BlockSearch(const ExactProblem& problem, const ExactSettings& settings, const RootLevels& levels)
      : problem_(problem), settings_(settings), levels_(levels) {}

  std::int64_t nodesScored() const { return nodes_scored_; }
  std::int64_t nodesExpanded() const { return nodes_expanded_; }

  /// Scores the initial nodes of a block and keeps those that reach `min_count`, the best first. False when the
  /// deadline passed before that.
  bool scoreRoots(RotationBlock& block, std::int32_t min_count);

  /// Searches below the initial nodes of a block. Bound of what the deadline left of those that the incumbent does not
  /// prune, 0 for nothing [cells].
  std::int32_t searchBelow(const RotationBlock& block, Incumbent& incumbent);

  /// Bound of the initial nodes of a block from `first` on that the incumbent does not prune, 0 for none [cells].
  std::int32_t boundOf(const RotationBlock& block, const Incumbent& incumbent, std::size_t first = 0) const;

 private:
  SearchWindow windowOf(int first_rotation, const BlockShape& shape) const;
  void enter(const RotationBlock& block);
  bool scoreWindow(int rotation, const SearchWindow& window, std::int32_t min_count, std::vector<RootNode>& roots);
  bool scoreWhereAnythingIs(int first_rotation, const SearchWindow& window, std::int32_t min_count,
                            std::vector<RootNode>& roots);
  bool scoreBelow(const std::vector<TileScore>& promising, const grid::Cell& first, int rotation,
                  const SearchWindow& window, std::int32_t min_count, std::vector<RootNode>& roots);
  void addRoots(int rotation, const grid::Cell& tile, std::vector<RootNode>& roots) const;
  bool scoreTile(const BlockShape& shape, int rotation, const grid::Cell& first, const TileSize& size,
                 std::int32_t min_count);
  SearchNode nodeOf(const RootNode& root) const { return {root.bound, root.rotation, root.first, levels_.nodes}; }
  std::int32_t boundOfRest(const Incumbent& incumbent) const;
  static void offer(const std::vector<SearchNode>& poses, Incumbent& incumbent);
  void addGroups(std::vector<SearchNode>& nodes);
  void expand(const NodeGroup& group, Incumbent& incumbent);
  void addChildren(const BlockShape& shape, int rotation, const grid::Cell& first, const Incumbent& incumbent);
  const WeightedCells& cellsOf(const BlockShape& shape, int rotation);

  const ExactProblem& problem_;
  const ExactSettings& settings_;
  RootLevels levels_;
  std::vector<TileScore> scores_;  // of the last tile
  int first_rotation_ = 0;
  std::vector<std::optional<WeightedCells>> block_cells_;
  std::vector<NodeGroup> groups_;     // to be expanded, the next one last
  std::vector<SearchNode> children_;  // of the last group
  std::int64_t nodes_scored_ = 0;
  std::int64_t nodes_expanded_ = 0;
};

}  // namespace map_matcher::search
