#include "map_matcher/search/weighted_cells.hpp"

#include <algorithm>

namespace map_matcher {

WeightedCells CellMerger::merge(const RotatedCells& cells, int block) {
  const auto total = static_cast<std::int32_t>(cells.x.size());
  if (block == 1) {
    return {cells, {{cells.x.size(), 1}}, total};
  }
  clearTable(cells.x.size());
  const int mask = -block;  // of a power of two: all bits but the lowest
  for (std::size_t k = 0; k < cells.x.size(); ++k) {
    add(static_cast<std::int16_t>(cells.x[k] & mask), static_cast<std::int16_t>(cells.y[k] & mask));
  }
  return sortedByWeight(total);
}

void CellMerger::clearTable(std::size_t num_cells) {
  merged_.x.clear();
  merged_.y.clear();
  weights_.clear();
  ++generation_;
  if (table_.size() >= 2 * num_cells && generation_ != 0) {
    return;
  }
  std::size_t size = 16;
  shift_ = 28;
  for (; size < 2 * num_cells; size *= 2) {
    --shift_;
  }
  table_.assign(size, {});
  generation_ = 1;
}

void CellMerger::add(std::int16_t x, std::int16_t y) {
  constexpr std::uint32_t kMultiplier = 2654435769U;  // 2^32 over the golden ratio: spreads neighbours (Knuth)
  const std::uint32_t key = static_cast<std::uint32_t>(static_cast<std::uint16_t>(y)) << 16 |
                            static_cast<std::uint32_t>(static_cast<std::uint16_t>(x));
  const std::uint32_t last = static_cast<std::uint32_t>(table_.size()) - 1;
  std::uint32_t place = key * kMultiplier >> shift_;
  while (table_[place].generation == generation_) {
    if (table_[place].key == key) {
      ++weights_[table_[place].index];
      return;
    }
    place = (place + 1) & last;
  }
  table_[place] = {key, generation_, static_cast<std::uint32_t>(weights_.size())};
  merged_.x.push_back(x);
  merged_.y.push_back(y);
  weights_.push_back(1);
}

WeightedCells CellMerger::sortedByWeight(std::int32_t total) const {
  const std::int32_t heaviest = weights_.empty() ? 0 : *std::max_element(weights_.begin(), weights_.end());
  std::vector<std::size_t> places(static_cast<std::size_t>(heaviest) + 1, 0);  // by how much lighter than the heaviest
  for (const std::int32_t weight : weights_) {
    ++places[static_cast<std::size_t>(heaviest - weight)];
  }
  WeightedCells result;
  result.total = total;
  std::size_t begin = 0;
  for (std::size_t lighter = 0; lighter < places.size(); ++lighter) {
    const std::size_t size = places[lighter];
    if (size > 0) {
      result.runs.push_back({size, heaviest - static_cast<std::int32_t>(lighter)});
    }
    places[lighter] = begin;
    begin += size;
  }
  result.cells.x.resize(weights_.size());
  result.cells.y.resize(weights_.size());
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const std::size_t place = places[static_cast<std::size_t>(heaviest - weights_[k])]++;
    result.cells.x[place] = merged_.x[k];
    result.cells.y[place] = merged_.y[k];
  }
  return result;
}

}  // namespace map_matcher
