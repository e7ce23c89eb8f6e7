#include "map_matcher/search/scouting.hpp"

#include <algorithm>
#include <numeric>

#include "map_matcher/search/score_kernel.hpp"

namespace map_matcher {
namespace {

/// At most `num_wanted` cells, equally spaced in the order of the cells.
RotatedCells everyKth(const RotatedCells& cells, int num_wanted) {
  const auto wanted = static_cast<std::size_t>(num_wanted);
  const std::size_t step = std::max<std::size_t>(1, (cells.x.size() + wanted - 1) / wanted);
  RotatedCells sample;
  for (std::size_t k = 0; k < cells.x.size(); k += step) {
    sample.x.push_back(cells.x[k]);
    sample.y.push_back(cells.y[k]);
  }
  return sample;
}

/// The most matches of the sample at any node of the window.
std::int32_t bestCount(const PooledLevel& level, const RotatedCells& sample, const SearchWindow& window) {
  const ScoreKernel kernel;
  std::vector<TileScore> scores;
  std::int32_t best = 0;
  for (int y = window.first.y; y <= window.last.y; y += level.stride() * kTileRows) {
    for (int x = window.first.x; x <= window.last.x; x += level.stride() * kTileColumns) {
      kernel.scoreTile(level, sample, {x, y}, {}, best + 1, scores);
      for (const TileScore& score : scores) {
        best = std::max(best, score.count);
      }
    }
  }
  return best;
}

}  // namespace

std::vector<std::size_t> promisingFirst(const SearchProblem& problem, int num_cells, const Deadline& deadline) {
  const PooledLevel& level = problem.reference.level(problem.root_level);
  std::vector<std::size_t> order(problem.rotations.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::int32_t> best(order.size(), 0);
  for (std::size_t n = 0; n < order.size() && !deadline.passed(); n += 2) {  // the next rotation is much the same
    const RotatedCells& cells = problem.rotations[n];
    const SearchWindow reachable = reachableWindow(problem.reference, cells, problem.min_count);
    best[n] = bestCount(level, everyKth(cells, num_cells), intersection(problem.windows[n], reachable));
    best[std::min(n + 1, best.size() - 1)] = best[n];
  }
  std::stable_sort(order.begin(), order.end(), [&best](std::size_t a, std::size_t b) { return best[a] > best[b]; });
  return order;
}

}  // namespace map_matcher
