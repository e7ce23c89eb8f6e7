#include "map_matcher/search/weighted_cells.hpp"

#include <algorithm>

namespace map_matcher {
namespace {

constexpr std::int64_t kMostBlocks = std::int64_t{1} << 24;  // of 4 bytes each

/// Logarithm of a power of two.
int shiftOf(int block) {
  int shift = 0;
  while (1 << shift < block) {
    ++shift;
  }
  return shift;
}

WeightedCells unmerged(const RotatedCells& cells) {
  return {cells, {{cells.x.size(), 1}}, static_cast<std::int32_t>(cells.x.size())};
}

struct Range {
  std::int16_t first;
  std::int16_t last;
};

/// As std::minmax_element, in a loop that compilers turn into vector instructions (ten times faster).
Range rangeOf(const std::vector<std::int16_t>& values) {
  Range range{values.front(), values.front()};
  for (const std::int16_t value : values) {
    range.first = value < range.first ? value : range.first;
    range.last = value > range.last ? value : range.last;
  }
  return range;
}

}  // namespace

WeightedCells CellMerger::merge(const RotatedCells& cells, int block) {
  if (block == 1 || cells.x.empty()) {
    return unmerged(cells);
  }
  const int shift = shiftOf(block);
  const Box box = boxOf(cells, shift);
  if (std::int64_t{box.width} * box.height > kMostBlocks) {
    return unmerged(cells);
  }
  countBlocks(cells, box, shift);
  return sortedByWeight(box, shift);
}

CellMerger::Box CellMerger::boxOf(const RotatedCells& cells, int shift) {
  const Range x = rangeOf(cells.x);
  const Range y = rangeOf(cells.y);
  return {x.first >> shift, y.first >> shift, (x.last >> shift) - (x.first >> shift) + 1,
          (y.last >> shift) - (y.first >> shift) + 1};
}

void CellMerger::countBlocks(const RotatedCells& cells, const Box& box, int shift) {
  const std::size_t num_blocks = static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
  weights_.resize(std::max(weights_.size(), num_blocks), 0);
  filled_.resize(cells.x.size());
  std::size_t num_filled = 0;
  for (std::size_t k = 0; k < cells.x.size(); ++k) {
    const int x = (cells.x[k] >> shift) - box.first_x;
    const int y = (cells.y[k] >> shift) - box.first_y;
    const auto index = static_cast<std::uint32_t>(y * box.width + x);
    filled_[num_filled] = index;  // overwritten unless this is the block's first cell
    num_filled += weights_[index]++ == 0 ? 1 : 0;
  }
  filled_.resize(num_filled);
}

WeightedCells CellMerger::sortedByWeight(const Box& box, int shift) {
  std::int32_t heaviest = 0;
  for (const std::uint32_t index : filled_) {
    heaviest = std::max(heaviest, weights_[index]);
  }
  std::vector<std::size_t> places(static_cast<std::size_t>(heaviest) + 1, 0);  // by how much lighter than the heaviest
  for (const std::uint32_t index : filled_) {
    ++places[static_cast<std::size_t>(heaviest - weights_[index])];
  }
  WeightedCells result;
  std::size_t begin = 0;
  for (std::size_t lighter = 0; lighter < places.size(); ++lighter) {
    const std::size_t size = places[lighter];
    result.total += static_cast<std::int32_t>(size) * (heaviest - static_cast<std::int32_t>(lighter));
    if (size > 0) {
      result.runs.push_back({size, heaviest - static_cast<std::int32_t>(lighter)});
    }
    places[lighter] = begin;
    begin += size;
  }
  result.cells.x.resize(filled_.size());
  result.cells.y.resize(filled_.size());
  const auto width = static_cast<std::uint32_t>(box.width);
  for (const std::uint32_t index : filled_) {
    const std::size_t place = places[static_cast<std::size_t>(heaviest - weights_[index])]++;
    result.cells.x[place] = static_cast<std::int16_t>((box.first_x + static_cast<int>(index % width)) * (1 << shift));
    result.cells.y[place] = static_cast<std::int16_t>((box.first_y + static_cast<int>(index / width)) * (1 << shift));
    weights_[index] = 0;
  }
  return result;
}

}  // namespace map_matcher
