#include "map_matcher/search/search_window.hpp"

#include <algorithm>
#include <vector>

namespace map_matcher {
namespace {

struct Range {
  int first;
  int last;
};

/// Translations t at which at least `min_matches` of the values v satisfy low <= v + t <= high, necessary condition:
/// the min_matches-th largest value reaches `low` and the min_matches-th smallest stays within `high`.
Range reachableRange(const std::vector<std::int16_t>& values, int min_matches, int low, int high) {
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  const int offset = *smallest;
  std::vector<int> histogram(static_cast<std::size_t>(*largest - offset + 1), 0);
  for (const std::int16_t value : values) {
    ++histogram[static_cast<std::size_t>(value - offset)];
  }
  int from_below = 0;
  for (int count = 0; (count += histogram[static_cast<std::size_t>(from_below)]) < min_matches;) {
    ++from_below;
  }
  int from_above = static_cast<int>(histogram.size()) - 1;
  for (int count = 0; (count += histogram[static_cast<std::size_t>(from_above)]) < min_matches;) {
    --from_above;
  }
  return {low - (from_above + offset), high - (from_below + offset)};
}

}  // namespace

SearchWindow intersection(const SearchWindow& a, const SearchWindow& b) {
  return {{std::max(a.first.x, b.first.x), std::max(a.first.y, b.first.y)},
          {std::min(a.last.x, b.last.x), std::min(a.last.y, b.last.y)}};
}

SearchWindow reachableWindow(const PrecomputedGrids& reference, const RotatedCells& cells, int min_matches) {
  const int wanted = std::clamp(min_matches, 1, static_cast<int>(cells.x.size()));
  const Range x = reachableRange(cells.x, wanted, reference.firstWall().x, reference.lastWall().x);
  const Range y = reachableRange(cells.y, wanted, reference.firstWall().y, reference.lastWall().y);
  return {{x.first, y.first}, {x.last, y.last}};
}

}  // namespace map_matcher
