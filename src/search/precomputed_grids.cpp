#include "map_matcher/search/precomputed_grids.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace map_matcher {
namespace {

constexpr int kMaxLevel = 15;

int divideUp(int value, int divisor) { return (value + divisor - 1) / divisor; }

/// Walls as ones in an array with `margin` zeros around the map.
std::vector<std::uint8_t> drawWalls(int width, int height, int margin, const std::vector<Cell>& walls) {
  const auto row_length = static_cast<std::size_t>(width + 2 * margin);
  std::vector<std::uint8_t> values(row_length * static_cast<std::size_t>(height + 2 * margin), 0);
  for (const Cell& wall : walls) {
    if (wall.x >= 0 && wall.y >= 0 && wall.x < width && wall.y < height) {
      values[static_cast<std::size_t>(wall.y + margin) * row_length + static_cast<std::size_t>(wall.x + margin)] = 1;
    }
  }
  return values;
}

/// Doubles the pooling window of every value, in place: from [x, x + reach) to [x, x + 2 reach), and y alike. Values
/// whose window would leave the array keep the smaller one; they lie in the margin beyond all walls.
void doubleWindow(std::vector<std::uint8_t>& values, std::size_t row_length, std::size_t reach) {
  const std::size_t num_rows = values.size() / row_length;
  for (std::size_t y = 0; y < num_rows; ++y) {
    std::uint8_t* row = &values[y * row_length];
    for (std::size_t x = 0; x + reach < row_length; ++x) {
      row[x] |= row[x + reach];
    }
    if (y >= reach) {  // the row below by `reach` has all it needs now
      std::uint8_t* lower = &values[(y - reach) * row_length];
      for (std::size_t x = 0; x < row_length; ++x) {
        lower[x] |= row[x];
      }
    }
  }
}

void requireAddressable(int width, int height, int level) {
  const int stride = 1 << level;
  const double columns = divideUp(width, stride) + 2.0 * kMaxTileColumns + 1.0;
  const double rows = divideUp(height, stride) + 2.0 * kMaxTileRows + 1.0;
  if (columns * rows * stride * stride > std::numeric_limits<int>::max()) {
    throw std::invalid_argument("the reference map is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, too large for level " + std::to_string(level) + " of the search");
  }
}

}  // namespace

PooledLevel::PooledLevel(int level, int width, int height, int margin, const std::vector<std::uint8_t>& pooled)
    : level_(level),
      columns_(divideUp(width, 1 << level)),
      rows_(divideUp(height, 1 << level)),
      row_stride_(columns_ + 2 * kMaxTileColumns + 1),
      phase_size_(row_stride_ * (rows_ + 2 * kMaxTileRows + 1)),
      origin_((kMaxTileRows + 1) * row_stride_ + kMaxTileColumns + 1),
      values_(static_cast<std::size_t>(phase_size_) << (2 * level), 0) {
  const int row_length = width + 2 * margin;
  for (int y = 1 - stride(); y < height; ++y) {
    const std::uint8_t* row = &pooled[static_cast<std::size_t>(y + margin) * static_cast<std::size_t>(row_length)];
    for (int phase = 0; phase < stride(); ++phase) {
      std::uint8_t* target = &values_[address(phase, y)];
      for (int x = phase == 0 ? 0 : phase - stride(); x < width; x += stride()) {
        target[x >> level_] = row[x + margin];
      }
    }
  }
}

PrecomputedGrids::PrecomputedGrids(int width, int height, const std::vector<Cell>& walls, int top_level)
    : width_(width), height_(height), first_wall_{width, height}, last_wall_{-1, -1} {
  if (width < 1 || height < 1) {
    throw std::invalid_argument("the reference map is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, expected at least 1 x 1");
  }
  if (top_level < 0 || top_level > kMaxLevel) {
    throw std::invalid_argument("top_level is " + std::to_string(top_level) + ", expected 0 to " +
                                std::to_string(kMaxLevel));
  }
  requireAddressable(width, height, top_level);
  for (const Cell& wall : walls) {
    first_wall_ = {std::min(first_wall_.x, wall.x), std::min(first_wall_.y, wall.y)};
    last_wall_ = {std::max(last_wall_.x, wall.x), std::max(last_wall_.y, wall.y)};
  }
  const int margin = 1 << top_level;
  std::vector<std::uint8_t> pooled = drawWalls(width, height, margin, walls);
  for (int level = 0; level <= top_level; ++level) {
    if (level > 0) {
      doubleWindow(pooled, static_cast<std::size_t>(width + 2 * margin), std::size_t{1} << (level - 1));
    }
    levels_.emplace_back(level, width, height, margin, pooled);
  }
}

std::size_t PrecomputedGrids::bytes() const {
  std::size_t sum = 0;
  for (const PooledLevel& level : levels_) {
    sum += level.bytes();
  }
  return sum;
}

}  // namespace map_matcher
