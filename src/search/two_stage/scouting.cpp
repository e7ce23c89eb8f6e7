#include "map_matcher/search/two_stage/scouting.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "map_matcher/search/counting/score_kernel.hpp"
#include "map_matcher/work/parallel.hpp"

namespace map_matcher::search {
namespace {

/// At most `num_wanted` cells, equally spaced in the order of the cells.
SessionCells everyKth(const SessionCells& session, int num_wanted) {
  const auto wanted = static_cast<std::size_t>(num_wanted);
  const std::size_t step = std::max<std::size_t>(1, (session.points.size() + wanted - 1) / wanted);
  SessionCells sample;
  for (std::size_t k = 0; k < session.points.size(); k += step) {
    sample.points.push_back(session.points[k]);
  }
  return sample;
}

/// The most matches of a sample at any node of the band's windows, and the number of the band.
struct Prospect {
  std::int32_t matches = 0;
  std::size_t band = 0;
};

std::int32_t mostMatches(const SearchProblem& problem, const RotationBand& band, const RotatedCells& sample,
                         int min_count) {
  const ScoreKernel kernel;
  SearchWindow window = reachableWindow(problem.reference, sample, min_count);
  window = intersection(window, problem.windows[static_cast<std::size_t>(band.rotations.front())]);
  const PooledLevel& level = problem.reference.level(problem.root_level);
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

void putPromisingFirst(SearchProblem& problem, const SessionCells& session, int num_cells,
                       const work::Deadline& deadline) {
  const SessionCells sample = everyKth(session, num_cells);
  const auto share = static_cast<double>(sample.points.size()) / static_cast<double>(session.points.size());
  const auto min_count = static_cast<int>(share * problem.min_count);  // rounding is no matter: it decides nothing
  std::vector<RotationBand>& bands = problem.bands;
  std::vector<Prospect> prospects(bands.size());
  work::parallelFor(problem.threads, bands.size(), [&](std::size_t n) {
    prospects[n].band = n;
    if (!deadline.passed()) {
      prospects[n].matches = mostMatches(problem, bands[n], rotate(sample, bands[n].middle), min_count);
    }
  });
  std::stable_sort(prospects.begin(), prospects.end(),
                   [](const Prospect& a, const Prospect& b) { return a.matches > b.matches; });
  std::vector<RotationBand> ordered;
  ordered.reserve(bands.size());
  for (const Prospect& prospect : prospects) {
    ordered.push_back(std::move(bands[prospect.band]));
  }
  bands = std::move(ordered);
}

}  // namespace map_matcher::search
