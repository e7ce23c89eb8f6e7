#include "map_matcher/search/counting/widened_grids.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace map_matcher::search {
namespace {

/// A tolerance of a whole number of cells is not to miss by the last bit of a division.
constexpr double kRounding = 1e-6;

void requireUsable(int width, int height, double tolerance, int top_level) {
  if (width < 1 || height < 1) {
    throw std::invalid_argument("the reference map is " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, expected at least 1 x 1");
  }
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance)) {
    throw std::invalid_argument("tolerance is " + std::to_string(tolerance) + ", expected at least 0 and finite");
  }
  if (top_level < 0 || top_level > BlockShape::kMaxLevel) {
    throw std::invalid_argument("top_level is " + std::to_string(top_level) + ", expected 0 to " +
                                std::to_string(BlockShape::kMaxLevel));
  }
}

/// Cells around (0, 0) whose centres lie within `tolerance` of its own.
std::vector<grid::Cell> disc(double tolerance, int reach) {
  const double farthest = (tolerance + kRounding) * (tolerance + kRounding);
  std::vector<grid::Cell> cells;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if (static_cast<double>(x) * x + static_cast<double>(y) * y <= farthest) {
        cells.push_back({x, y});
      }
    }
  }
  return cells;
}

}  // namespace

WidenedGrids::WidenedGrids(int width, int height, const std::vector<grid::Cell>& walls, double tolerance, int top_level,
                           const work::Deadline& deadline)
    : first_hit_{width, height}, last_hit_{-1, -1} {
  requireUsable(width, height, tolerance, top_level);
  const double useful_tolerance = std::min<double>(tolerance, width + height);
  reach_ = static_cast<int>(std::floor(useful_tolerance + kRounding));
  const BlockShape top{top_level};
  WallArray pooled(width, height, reach_ + top.window() + top.stride());
  const std::vector<grid::Cell> hits = disc(useful_tolerance, reach_);
  for (const grid::Cell& wall : walls) {
    if (wall.x < 0 || wall.y < 0 || wall.x >= width || wall.y >= height) {
      continue;
    }
    deadline.throwIfPassed();
    for (const grid::Cell& hit : hits) {
      pooled.draw(wall.x + hit.x, wall.y + hit.y);
    }
    first_hit_ = {std::min(first_hit_.x, wall.x - reach_), std::min(first_hit_.y, wall.y - reach_)};
    last_hit_ = {std::max(last_hit_.x, wall.x + reach_), std::max(last_hit_.y, wall.y + reach_)};
  }
  for (int level = 0; level <= top_level; ++level) {
    if (level > 0) {
      pooled.growWindow(BlockShape{level - 1}.window(), BlockShape{level}.window(), deadline);
    }
    const BlockShape shape{level};
    const int phases = shape.level - shape.grainLevel();
    const int columns = (width + reach_) / shape.grain() + 1 + shift(level);
    const int rows = (height + reach_) / shape.grain() + 1 + shift(level);
    levels_.emplace_back(phases, columns, rows, pooled, shift(level), shape.grain(), deadline);
  }
}

/// Steps from the first window that holds a hit to the one that begins at the map's corner, or more.
int WidenedGrids::shift(int level) const {
  const BlockShape shape{level};
  return (reach_ + shape.spread()) / shape.grain() + 1;
}

grid::Cell WidenedGrids::position(int level, const grid::Cell& first) const {
  const int grain = BlockShape{level}.grainLevel();
  return {(first.x >> grain) + shift(level), (first.y >> grain) + shift(level)};
}

std::size_t WidenedGrids::bytes() const {
  std::size_t sum = 0;
  for (const PooledLevel& level : levels_) {
    sum += level.bytes();
  }
  return sum;
}

}  // namespace map_matcher::search
