#include "map_matcher/search/search_window.hpp"

#include <algorithm>
#include <vector>

namespace map_matcher {
namespace {

struct Range {
  int first;
  int last;
};

using Runs = std::vector<WeightedCells::Run>;

/// How much weight lies at each value, from `offset` on.
struct Histogram {
  int offset;
  std::vector<int> weights;
};

Histogram histogramOf(const std::vector<std::int16_t>& values, const Runs& runs) {
  std::int16_t smallest = values.front();
  std::int16_t largest = values.front();
  for (const std::int16_t value : values) {  // compilers turn this into vector instructions, not std::minmax_element
    smallest = value < smallest ? value : smallest;
    largest = value > largest ? value : largest;
  }
  Histogram histogram{smallest, std::vector<int>(static_cast<std::size_t>(largest - smallest + 1), 0)};
  auto value = values.begin();
  for (const WeightedCells::Run& run : runs) {
    for (const auto end = value + static_cast<std::ptrdiff_t>(run.size); value != end; ++value) {
      histogram.weights[static_cast<std::size_t>(*value - histogram.offset)] += run.weight;
    }
  }
  return histogram;
}

/// Translations t at which at least `min_matches` of the values v satisfy low <= v + t <= high, necessary condition:
/// the min_matches-th largest value reaches `low` and the min_matches-th smallest stays within `high`.
Range reachableRange(const std::vector<std::int16_t>& values, const Runs& runs, int min_matches, int low, int high) {
  const Histogram histogram = histogramOf(values, runs);
  int from_below = 0;
  for (int count = 0; (count += histogram.weights[static_cast<std::size_t>(from_below)]) < min_matches;) {
    ++from_below;
  }
  int from_above = static_cast<int>(histogram.weights.size()) - 1;
  for (int count = 0; (count += histogram.weights[static_cast<std::size_t>(from_above)]) < min_matches;) {
    --from_above;
  }
  return {low - (from_above + histogram.offset), high - (from_below + histogram.offset)};
}

}  // namespace

SearchWindow intersection(const SearchWindow& a, const SearchWindow& b) {
  return {{std::max(a.first.x, b.first.x), std::max(a.first.y, b.first.y)},
          {std::min(a.last.x, b.last.x), std::min(a.last.y, b.last.y)}};
}

SearchWindow reachableWindow(const PrecomputedGrids& reference, const RotatedCells& cells, int min_matches) {
  const Runs runs{{cells.x.size(), 1}};
  const int wanted = std::clamp(min_matches, 1, static_cast<int>(cells.x.size()));
  const Range x = reachableRange(cells.x, runs, wanted, reference.firstWall().x, reference.lastWall().x);
  const Range y = reachableRange(cells.y, runs, wanted, reference.firstWall().y, reference.lastWall().y);
  return {{x.first, y.first}, {x.last, y.last}};
}

SearchWindow reachableWindow(const WidenedGrids& reference, const BlockShape& shape, const WeightedCells& cells,
                             int min_matches) {
  const int spread = shape.window() - shape.stride();  // of the session cells that one of these stands for
  const int wanted = std::clamp(min_matches, 1, cells.total);
  const Cell& first = reference.firstHit();
  const Cell& last = reference.lastHit();
  const Range x = reachableRange(cells.cells.x, cells.runs, wanted, first.x - spread, last.x);
  const Range y = reachableRange(cells.cells.y, cells.runs, wanted, first.y - spread, last.y);
  return {{x.first, y.first}, {x.last, y.last}};
}

}  // namespace map_matcher
