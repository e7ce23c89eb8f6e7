#include "map_matcher/search/counting/search_window.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vector_clones.hpp"

namespace map_matcher::search {
namespace {

struct Range {
  int first;
  int last;
};

using Runs = std::vector<WeightedCells::Run>;

using Values = std::vector<std::int16_t>;

MAP_MATCHER_VECTOR_CLONES
Range rangeOf(const std::int16_t* values, std::size_t size) {
  std::int16_t first = values[0];
  std::int16_t last = values[0];
  for (std::size_t k = 0; k < size; ++k) {  // compilers turn this into vector instructions, not std::minmax_element
    first = values[k] < first ? values[k] : first;
    last = values[k] > last ? values[k] : last;
  }
  return {first, last};
}

/// Sixteen bits are enough for the count of a part, and twice as many fit into a vector as of 32.
MAP_MATCHER_VECTOR_CLONES
std::int32_t countUpTo(const std::int16_t* values, std::size_t size, std::int16_t limit) {
  constexpr std::size_t kPart = 32768;
  std::int32_t count = 0;
  for (std::size_t begin = 0; begin < size; begin += kPart) {
    const std::size_t end = std::min(begin + kPart, size);
    std::uint16_t part = 0;
    for (std::size_t k = begin; k < end; ++k) {
      part = static_cast<std::uint16_t>(part + (values[k] <= limit ? 1 : 0));
    }
    count += part;
  }
  return count;
}

/// Weight of all values up to a limit.
std::int32_t weightUpTo(const Values& values, const Runs& runs, int limit) {
  const std::int16_t* value = values.data();
  std::int32_t weight = 0;
  for (const WeightedCells::Run& run : runs) {
    weight += run.weight * countUpTo(value, run.size, static_cast<std::int16_t>(limit));
    value += run.size;
  }
  return weight;
}

/// The smallest value such that `weight` lies at it and below. Each step of the bisection counts, in vector
/// instructions; a sort or a histogram takes longer.
int quantile(const Values& values, const Runs& runs, const Range& range, std::int32_t weight) {
  int low = range.first;
  int high = range.last;
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (weightUpTo(values, runs, middle) >= weight) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

/// Translations t at which at least `min_matches` of the values v satisfy low <= v * grain + t <= high, necessary
/// condition: the min_matches-th largest value reaches `low` and the min_matches-th smallest stays within `high`.
Range reachableRange(const Values& values, const Runs& runs, int total, int min_matches, int low, int high, int grain) {
  const Range range = rangeOf(values.data(), values.size());
  const int smallest = quantile(values, runs, range, min_matches);
  const int largest = quantile(values, runs, range, total - min_matches + 1);
  return {low - largest * grain, high - smallest * grain};
}

}  // namespace

SearchWindow intersection(const SearchWindow& a, const SearchWindow& b) {
  return {{std::max(a.first.x, b.first.x), std::max(a.first.y, b.first.y)},
          {std::min(a.last.x, b.last.x), std::min(a.last.y, b.last.y)}};
}

SearchWindow hull(const SearchWindow& a, const SearchWindow& b) {
  return {{std::min(a.first.x, b.first.x), std::min(a.first.y, b.first.y)},
          {std::max(a.last.x, b.last.x), std::max(a.last.y, b.last.y)}};
}

SearchWindow reachableWindow(const PrecomputedGrids& reference, const RotatedCells& cells, int min_matches, int reach) {
  const Runs runs{{cells.x.size(), 1}};
  const auto total = static_cast<int>(cells.x.size());
  const int wanted = std::clamp(min_matches, 1, total);
  const grid::Cell first{reference.firstWall().x - reach, reference.firstWall().y - reach};
  const grid::Cell last{reference.lastWall().x + reach, reference.lastWall().y + reach};
  const Range x = reachableRange(cells.x, runs, total, wanted, first.x, last.x, 1);
  const Range y = reachableRange(cells.y, runs, total, wanted, first.y, last.y, 1);
  return {{x.first, y.first}, {x.last, y.last}};
}

SearchWindow reachableWindow(const WidenedGrids& reference, const BlockShape& shape, const WeightedCells& cells,
                             int min_matches) {
  const int wanted = std::clamp(min_matches, 1, cells.total);
  const grid::Cell& first = reference.firstHit();
  const grid::Cell& last = reference.lastHit();
  const int grain = shape.grain();
  const Range x =
      reachableRange(cells.cells.x, cells.runs, cells.total, wanted, first.x - shape.spread(), last.x, grain);
  const Range y =
      reachableRange(cells.cells.y, cells.runs, cells.total, wanted, first.y - shape.spread(), last.y, grain);
  return {{x.first, y.first}, {x.last, y.last}};
}

}  // namespace map_matcher::search
