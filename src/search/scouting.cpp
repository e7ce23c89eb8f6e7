#include "map_matcher/search/scouting.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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

/// The most matches of a sample at any node of the band's windows, and the number of the band.
struct Prospect {
  std::int32_t matches = 0;
  std::size_t band = 0;
};

std::int32_t mostMatches(const SearchProblem& problem, const RotationBand& band, int num_cells) {
  const RotatedCells sample = everyKth(band.cells, num_cells);
  const auto share = static_cast<double>(sample.x.size()) / static_cast<double>(band.cells.x.size());
  SearchWindow window =
      reachableWindow(problem.reference, sample, static_cast<int>(share * static_cast<double>(problem.min_count)));
  window = intersection(window, problem.windows[static_cast<std::size_t>(band.rotations.front())]);
  const PooledLevel& level = problem.reference.level(problem.root_level);
  const ScoreKernel kernel;
  std::int32_t most = 0;
  for (int y = window.first.y; y <= window.last.y; y += level.stride() * kTileRows) {
    for (int x = window.first.x; x <= window.last.x; x += level.stride() * kTileColumns) {
      const TileSize size = tileWithin(window.last, {x, y}, level.stride());
      most = std::max(most, kernel.bestCount(level, sample, {x, y}, size));
    }
  }
  return most;
}

}  // namespace

void putPromisingFirst(SearchProblem& problem, int num_cells, const Deadline& deadline) {
  std::vector<RotationBand>& bands = problem.bands;
  std::vector<Prospect> prospects(bands.size());
  for (std::size_t n = 0; n < bands.size(); ++n) {
    prospects[n] = {deadline.passed() ? 0 : mostMatches(problem, bands[n], num_cells), n};
  }
  std::stable_sort(prospects.begin(), prospects.end(),
                   [](const Prospect& a, const Prospect& b) { return a.matches > b.matches; });
  std::vector<RotationBand> ordered;
  for (const Prospect& prospect : prospects) {
    ordered.push_back(std::move(bands[prospect.band]));
  }
  bands = std::move(ordered);
}

}  // namespace map_matcher
