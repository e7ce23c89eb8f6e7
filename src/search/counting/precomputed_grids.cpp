#include "map_matcher/search/counting/precomputed_grids.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace map_matcher::search {
namespace {

constexpr int kMaxLevel = 15;

int divideUp(int value, int divisor) { return (value + divisor - 1) / divisor; }

/// Adds the walls of one row to those of another. The rows do not overlap, so that the loop vectorises.
void mergeRows(const std::uint8_t* __restrict from, std::uint8_t* __restrict to, std::ptrdiff_t length) {
  for (std::ptrdiff_t x = 0; x < length; ++x) {
    to[x] = static_cast<std::uint8_t>(to[x] | from[x]);
  }
}

void requireAddressable(int width, int height, int level) {
  const int stride = 1 << level;
  const double columns = divideUp(width, stride) + 2.0 * kTileColumns + 1.0;
  const double rows = divideUp(height, stride) + kTileRows + 2.0;
  if (columns * rows * stride * stride > std::numeric_limits<int>::max()) {
    throw std::invalid_argument("the reference map is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, too large for level " + std::to_string(level) + " of the search");
  }
}

}  // namespace

WallArray::WallArray(int width, int height, int margin)
    : margin_(margin),
      row_length_(width + 2 * margin),
      num_rows_(height + 2 * margin),
      values_(static_cast<std::size_t>(row_length_ * num_rows_), 0) {}

void WallArray::draw(int x, int y) {
  if (x >= -margin_ && y >= -margin_ && x < row_length_ - margin_ && y < num_rows_ - margin_) {
    values_[static_cast<std::size_t>(index(x, y))] = 1;
  }
}

void WallArray::growWindow(int old_window, int window, const work::Deadline& deadline) {
  for (int reached = old_window; reached < window;) {
    const int shift = std::min(reached, window - reached);
    mergeShifted(shift, deadline);
    reached += shift;
  }
}

void WallArray::mergeShifted(std::ptrdiff_t shift, const work::Deadline& deadline) {
  std::vector<std::uint8_t> shifted(static_cast<std::size_t>(row_length_), 0);
  for (std::ptrdiff_t y = 0; y < num_rows_; ++y) {
    deadline.throwIfPassed();
    std::uint8_t* row = values_.data() + y * row_length_;
    std::copy(row + shift, row + row_length_, shifted.begin());
    mergeRows(shifted.data(), row, row_length_);
    if (y >= shift) {  // the row below by `shift` has all it needs now
      mergeRows(row, row - shift * row_length_, row_length_);
    }
  }
}

PooledLevel::PooledLevel(int level, int width, int height, const WallArray& pooled, int shift, int grain,
                         const work::Deadline& deadline)
    : level_(level),
      columns_(divideUp(width, 1 << level)),
      rows_(divideUp(height, 1 << level)),
      row_length_(columns_ + 2 * kTileColumns + 1),
      phase_size_(row_length_ * (rows_ + kTileRows + 2)),
      origin_((kTileRows + 1) * row_length_ + kTileColumns + 1) {
  requireAddressable(width, height, level);
  words_.assign(static_cast<std::size_t>(phase_size_) << (2 * level), 0);
  const int first = std::max(1 - stride(), shift - pooled.margin() / grain);  // along both axes
  const int end_x = std::min(width, divideUp(pooled.width() + pooled.margin(), grain) + shift);
  const int end_y = std::min(height, divideUp(pooled.height() + pooled.margin(), grain) + shift);
  for (int y = first; y < end_y; ++y) {
    deadline.throwIfPassed();
    const std::uint8_t* row = pooled.row((y - shift) * grain) - static_cast<std::ptrdiff_t>(shift) * grain;
    for (int phase = 0; phase < stride(); ++phase) {
      TileWord* target = &words_[address(phase, y)];
      const int behind = (phase - first) & (stride() - 1);  // the first column of the phase
      for (int x = first + behind; x < end_x; x += stride()) {
        target[x >> level_] = row[static_cast<std::ptrdiff_t>(x) * grain];
      }
    }
  }
  for (std::ptrdiff_t phase = 0; phase < std::ptrdiff_t{1} << (2 * level); ++phase) {
    spreadRows(phase, deadline);
  }
}

/// Gives each word of a phase, whose lowest bit is set by now, the bits of the rows above.
void PooledLevel::spreadRows(std::ptrdiff_t phase, const work::Deadline& deadline) {
  TileWord* row = words_.data() + (phase + 1) * phase_size_ - row_length_;  // the last one, all zeros
  for (int j = rows_ - 1; j >= -kTileRows - 1; --j) {
    deadline.throwIfPassed();
    const TileWord* above = row;
    row -= row_length_;
    for (int i = 0; i < row_length_; ++i) {
      row[i] = static_cast<TileWord>(row[i] | (above[i] << 1));
    }
  }
}

PrecomputedGrids::PrecomputedGrids(int width, int height, const std::vector<grid::Cell>& walls, int top_level,
                                   int top_band_level, const work::Deadline& deadline)
    : width_(width), height_(height), first_wall_{width, height}, last_wall_{-1, -1} {
  if (width < 1 || height < 1) {
    throw std::invalid_argument("the reference map is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, expected at least 1 x 1");
  }
  if (top_level < 0 || std::max(top_level, top_band_level) > kMaxLevel) {
    throw std::invalid_argument("top_level is " + std::to_string(top_level) + " and top_band_level " +
                                std::to_string(top_band_level) + ", expected 0 to " + std::to_string(kMaxLevel));
  }
  WallArray pooled(width, height, (1 << std::max(top_level, top_band_level)) + 2 * kBandReach);
  for (const grid::Cell& wall : walls) {
    if (wall.x >= 0 && wall.y >= 0 && wall.x < width && wall.y < height) {
      pooled.draw(wall.x, wall.y);
    }
    first_wall_ = {std::min(first_wall_.x, wall.x), std::min(first_wall_.y, wall.y)};
    last_wall_ = {std::max(last_wall_.x, wall.x), std::max(last_wall_.y, wall.y)};
  }
  WallArray band = pooled;
  for (int level = 0; level <= top_level; ++level) {
    if (level > 0) {
      pooled.growWindow(1 << (level - 1), 1 << level, deadline);
    }
    levels_.emplace_back(level, width, height, pooled, 0, 1, deadline);
  }
  constexpr int kShift = 2 * kBandReach;
  for (int level = 0; level <= top_band_level; ++level) {
    band.growWindow(level == 0 ? 1 : (1 << (level - 1)) + kShift, (1 << level) + kShift, deadline);
    band_levels_.emplace_back(level, width + kShift, height + kShift, band, kShift, 1, deadline);
  }
}

std::size_t PrecomputedGrids::bytes() const {
  std::size_t sum = 0;
  for (const std::vector<PooledLevel>* levels : {&levels_, &band_levels_}) {
    for (const PooledLevel& level : *levels) {
      sum += level.bytes();
    }
  }
  return sum;
}

}  // namespace map_matcher::search
