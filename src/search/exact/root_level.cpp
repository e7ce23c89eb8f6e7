#include "root_level.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace map_matcher::search {
namespace {

constexpr int kSampledBlocks = 6;

// What one of the points that stand for the session costs in each step, in nanoseconds of one core; only their ratios
// matter (benchmark: BM_Certified).
constexpr double kRotating = 3.0;                                           // rotating it, for a block
constexpr double kScoringTile = 2.0;                                        // counting it for a tile of nodes
constexpr double kScoringNode = kScoringTile / (kTileColumns * kTileRows);  // for an initial node, one of a tile

/// Expected cost of the whole search at a level.
struct LevelCost {
  double roots = 0.0;      // of scoring all nodes of the level
  double expanding = 0.0;  // of expanding those that may hold the answer
  double promising = 0.0;  // share of the tiles one level below that may hold any
};

/// Tiles of the level below, of one rotation block, that hold initial nodes.
std::size_t promisingTiles(const RotationBlock& block, int level) {
  std::set<std::pair<int, int>> tiles;
  for (const RootNode& root : block.roots) {
    tiles.emplace((root.first.x >> level) * 2 / kTileColumns, (root.first.y >> level) * 2 / kTileRows);
  }
  return tiles.size();
}

LevelCost costOf(const ExactProblem& problem, const ExactSettings& settings, int level, std::int32_t min_count) {
  const BlockShape shape{level};
  const int num_blocks = (problem.rotations.count() + shape.stride() - 1) / shape.stride();
  const int num_sampled = std::min(kSampledBlocks, num_blocks);
  BlockSearch search(problem, settings, {level, level});
  double promising_blocks = 0.0;
  double tiles = 0.0;
  for (int k = 0; k < num_sampled; ++k) {
    RotationBlock block;
    block.first_rotation = num_blocks * (2 * k + 1) / (2 * num_sampled) * shape.stride();
    search.scoreRoots(block, min_count);
    promising_blocks += block.roots.empty() ? 0.0 : 1.0;
    tiles += static_cast<double>(promisingTiles(block, level));
  }
  const double here = problem.rotations.numPoints(shape);
  const double below = problem.rotations.numPoints(BlockShape{level - 1});
  const double share = static_cast<double>(num_blocks) / std::max(1, num_sampled);
  const double expanding = 2.0 * below * (promising_blocks * kRotating + tiles * kScoringTile);  // two rotations
  const auto scored = static_cast<double>(search.nodesScored());
  constexpr double kNodesOfTile = kTileColumns * kTileRows / 4.0;  // of which one a level below has as many
  return {share * (num_sampled * here * kRotating + scored * here * kScoringNode), share * expanding,
          std::min(1.0, tiles * kNodesOfTile / std::max(1.0, scored))};
}

}  // namespace

RootLevels cheapestRootLevels(const ExactProblem& problem, const ExactSettings& settings, std::int32_t min_count) {
  // From a level on, the promising nodes of all levels below it are expanded as well. So a level is worth its initial
  // nodes as long as they cost less than expanding those of the levels above it.
  const int top = problem.reference.topLevel();
  RootLevels best{top, top};
  double best_cost = std::numeric_limits<double>::infinity();  // without the levels below the one just sampled
  LevelCost above{best_cost, 0.0, 1.0};
  for (int level = top; level >= 1 && !settings.deadline.passed(); --level) {
    if (level < top && above.roots >= best_cost) {  // the initial nodes of this level cost more than those above
      break;
    }
    const LevelCost cost = costOf(problem, settings, level, min_count);
    const double sieved = above.roots + above.promising * cost.roots;
    const double roots = std::min(cost.roots, sieved);
    best_cost += cost.expanding;
    if (roots >= best_cost) {
      break;
    }
    if (roots + cost.expanding < best_cost) {
      best = {level, sieved < cost.roots ? level + 1 : level};
      best_cost = roots + cost.expanding;
    }
    above = cost;
  }
  return best;
}

}  // namespace map_matcher::search
