#include "map_matcher/mapping/hit_counting_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace map_matcher::mapping {
namespace {

constexpr int kGrowth = 32;          // [cells] the grid grows by multiples of this
constexpr double kPlaces = 65536.0;  // in a cell, along each axis, that a mean can lie at
constexpr int kLongestMean = 64;     // hits; later ones count as much as the last of these

int ceilToCell(double coordinate, double resolution) {
  constexpr double kFarthest = grid::kFarthestCell;
  // Tolerates the rounding error of a coordinate that is meant to be a multiple of the resolution.
  return static_cast<int>(std::clamp(std::ceil(coordinate / resolution - 1e-9), -kFarthest, kFarthest));
}

/// The smallest multiple of kGrowth that is at least `missing` cells; 0 when none are missing.
std::int64_t growthFor(std::int64_t missing) { return missing <= 0 ? 0 : (missing + kGrowth - 1) / kGrowth * kGrowth; }

/// Walks along one axis of the grid from line to line (Amanatides and Woo, "A fast voxel traversal algorithm", 1987).
/// Times are fractions of the beam.
struct AxisWalk {
  AxisWalk(double from, double to, double resolution, int cell)
      : step(to > from ? 1 : -1),
        period(to == from ? kNever : resolution / std::abs(to - from)),
        next(to == from ? kNever : ((cell + (step > 0 ? 1 : 0)) * resolution - from) / (to - from)) {}

  static constexpr double kNever = std::numeric_limits<double>::infinity();
  int step;       // +1 or -1 [cells]
  double period;  // time between two lines
  double next;    // time of the next line
};

}  // namespace

HitCountingGrid::HitCountingGrid(double resolution, const Extent& extent) : resolution_(resolution) {
  if (!std::isfinite(resolution) || resolution <= 0.0) {
    throw std::invalid_argument("the resolution is " + std::to_string(resolution) +
                                ", expected a positive number of metres per cell");
  }
  if (!extent.min.allFinite() || !extent.max.allFinite() || (extent.max.array() <= extent.min.array()).any()) {
    throw std::invalid_argument("the extent is (" + std::to_string(extent.min.x()) + ", " +
                                std::to_string(extent.min.y()) + ") to (" + std::to_string(extent.max.x()) + ", " +
                                std::to_string(extent.max.y()) + ") m, expected min < max");
  }
  first_ = latticeCell(extent.min.array() + 1e-9 * resolution);
  const auto width = std::int64_t{ceilToCell(extent.max.x(), resolution)} - first_.x;
  const auto height = std::int64_t{ceilToCell(extent.max.y(), resolution)} - first_.y;
  if (width > kMaxCells || height > kMaxCells || width * height > kMaxCells) {
    throw std::invalid_argument("the extent takes " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells, expected at most " + std::to_string(kMaxCells));
  }
  width_ = static_cast<int>(width);
  height_ = static_cast<int>(height);
  counts_.resize(static_cast<std::size_t>(width * height));
}

bool HitCountingGrid::draw(const BeamFan& fan) {
  Eigen::Vector2d lower = fan.origin;
  Eigen::Vector2d upper = fan.origin;
  for (const Beam& beam : fan.beams) {
    lower = lower.cwiseMin(beam.end);
    upper = upper.cwiseMax(beam.end);
  }
  if (!growTo(latticeCell(lower), latticeCell(upper))) {
    return false;
  }
  for (const Beam& beam : fan.beams) {
    const grid::Cell end = latticeCell(beam.end);
    visitCells(fan.origin, beam.end, [&](const grid::Cell& cell) { count(cell, beam.end, beam.hit && cell == end); });
  }
  return true;
}

grid::OccupancyGrid HitCountingGrid::toOccupancyGrid(double occupied_threshold) const {
  grid::GridGeometry geometry;
  geometry.resolution = resolution_;
  geometry.width = width_;
  geometry.height = height_;
  geometry.T_map_grid = {first_.x * resolution_, first_.y * resolution_, 0.0};
  std::vector<std::int8_t> values(counts_.size());
  std::transform(counts_.begin(), counts_.end(), values.begin(), [occupied_threshold](const Counts& counts) {
    if (counts.visits == 0) {
      return grid::kUnknown;
    }
    return isWall(counts, occupied_threshold) ? grid::kOccupied : grid::kFree;
  });
  return grid::OccupancyGrid(geometry, std::move(values));
}

grid::Cell HitCountingGrid::latticeCell(const Eigen::Vector2d& point) const { return grid::cellOf(point, resolution_); }

bool HitCountingGrid::growTo(const grid::Cell& lower, const grid::Cell& upper) {
  const std::int64_t left = growthFor(std::int64_t{first_.x} - lower.x);
  const std::int64_t down = growthFor(std::int64_t{first_.y} - lower.y);
  const std::int64_t right = growthFor(std::int64_t{upper.x} - first_.x - width_ + 1);
  const std::int64_t up = growthFor(std::int64_t{upper.y} - first_.y - height_ + 1);
  if (left + down + right + up == 0) {
    return true;
  }
  const std::int64_t width = left + width_ + right;
  const std::int64_t height = down + height_ + up;
  if (width > kMaxCells || height > kMaxCells || width * height > kMaxCells) {
    return false;
  }
  std::vector<Counts> grown(static_cast<std::size_t>(width * height));
  for (std::int64_t y = 0; y < height_; ++y) {
    const auto row = counts_.begin() + y * width_;
    std::copy(row, row + width_, grown.begin() + (down + y) * width + left);
  }
  counts_ = std::move(grown);
  first_ = {first_.x - static_cast<int>(left), first_.y - static_cast<int>(down)};
  width_ = static_cast<int>(width);
  height_ = static_cast<int>(height);
  return true;
}

/// Visits the cells of a straight line in their order, the last one too.
template <typename Visit>
void HitCountingGrid::visitCells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visit&& visit) const {
  const grid::Cell end = latticeCell(to);
  grid::Cell cell = latticeCell(from);
  AxisWalk walk_x(from.x(), to.x(), resolution_, cell.x);
  AxisWalk walk_y(from.y(), to.y(), resolution_, cell.y);
  // The number of lines to cross is known in integers, so rounding cannot lead past the last cell.
  for (int lines = std::abs(end.x - cell.x) + std::abs(end.y - cell.y); lines > 0; --lines) {
    visit(cell);
    const bool along_x = cell.y == end.y || (cell.x != end.x && walk_x.next < walk_y.next);
    AxisWalk& walk = along_x ? walk_x : walk_y;
    (along_x ? cell.x : cell.y) += walk.step;
    walk.next += walk.period;
  }
  visit(end);
}

void HitCountingGrid::count(const grid::Cell& lattice_cell, const Eigen::Vector2d& end, bool hit) {
  Counts& counts = counts_[indexOf(lattice_cell)];
  if (counts.visits == std::numeric_limits<std::uint16_t>::max()) {
    counts.hits = static_cast<std::uint16_t>(counts.hits / 2);
    counts.visits = static_cast<std::uint16_t>(counts.visits / 2);
  }
  ++counts.visits;
  if (hit) {
    ++counts.hits;
    const int weight = std::min<int>(counts.hits, kLongestMean);
    const auto follow = [this, weight](std::uint16_t& mean, double coordinate, int cell) {
      const double place = std::clamp((coordinate / resolution_ - cell) * kPlaces, 0.0, kPlaces - 1.0);
      mean = static_cast<std::uint16_t>(mean + static_cast<int>(place - mean) / weight);
    };
    follow(counts.mean_x, end.x(), lattice_cell.x);
    follow(counts.mean_y, end.y(), lattice_cell.y);
  }
}

std::vector<WallPoint> HitCountingGrid::wallsIn(const Extent& extent, double occupied_threshold) const {
  const grid::Cell lower = latticeCell(extent.min);
  const grid::Cell upper = latticeCell(extent.max);
  const int left = std::max(lower.x, first_.x);
  const int right = std::min(upper.x, first_.x + width_ - 1);
  std::vector<WallPoint> walls;
  for (int y = std::max(lower.y, first_.y); y <= std::min(upper.y, first_.y + height_ - 1); ++y) {
    for (int x = left; x <= right; ++x) {
      const Counts& counts = counts_[indexOf({x, y})];
      if (counts.hits > 0 && isWall(counts, occupied_threshold)) {
        walls.push_back(
            {resolution_ * Eigen::Vector2d(x + counts.mean_x / kPlaces, y + counts.mean_y / kPlaces), counts.hits});
      }
    }
  }
  return walls;
}

bool HitCountingGrid::isKnown(const Eigen::Vector2d& point) const {
  const grid::Cell cell = latticeCell(point);
  return holds(cell) && counts_[indexOf(cell)].visits > 0;
}

double HitCountingGrid::shareThroughWalls(const BeamFan& fan, double occupied_threshold, double margin) const {
  int through = 0;
  for (const Beam& beam : fan.beams) {
    const Eigen::Vector2d way = beam.end - fan.origin;
    const double length = way.norm();
    if (length <= margin) {
      continue;
    }
    bool crosses = false;
    if (const auto line = partWithin({fan.origin, fan.origin + (1.0 - margin / length) * way})) {
      visitCells(line->from, line->to, [&](const grid::Cell& cell) {
        crosses = crosses || (holds(cell) && isWall(counts_[indexOf(cell)], occupied_threshold));
      });
    }
    through += crosses ? 1 : 0;
  }
  return fan.beams.empty() ? 0.0 : static_cast<double>(through) / static_cast<double>(fan.beams.size());
}

/// The part of a line that may cross cells of the grid, which is all that a walk along it needs; nothing when none
/// does. (Liang and Barsky, "A new concept and method for line clipping", 1984.)
std::optional<HitCountingGrid::Line> HitCountingGrid::partWithin(const Line& line) const {
  const Eigen::Vector2d lower = resolution_ * Eigen::Vector2d(first_.x - 1.0, first_.y - 1.0);
  const Eigen::Vector2d upper = lower + resolution_ * Eigen::Vector2d(width_ + 2.0, height_ + 2.0);
  const Eigen::Vector2d way = line.to - line.from;
  double enters = 0.0;  // shares of the way
  double leaves = 1.0;
  for (const int axis : {0, 1}) {
    const double to_lower = lower[axis] - line.from[axis];
    const double to_upper = upper[axis] - line.from[axis];
    if (way[axis] == 0.0) {
      leaves = to_lower <= 0.0 && to_upper >= 0.0 ? leaves : -1.0;
    } else {
      enters = std::max(enters, std::min(to_lower / way[axis], to_upper / way[axis]));
      leaves = std::min(leaves, std::max(to_lower / way[axis], to_upper / way[axis]));
    }
  }
  if (!way.allFinite() || !(enters <= leaves)) {
    return std::nullopt;
  }
  const auto at = [&](double share) -> Eigen::Vector2d {  // within, though it be rounded
    return (line.from + share * way).cwiseMax(lower).cwiseMin(upper);
  };
  return Line{enters > 0.0 ? at(enters) : line.from, leaves < 1.0 ? at(leaves) : line.to};
}

bool HitCountingGrid::holds(const grid::Cell& lattice_cell) const {
  return lattice_cell.x >= first_.x && lattice_cell.y >= first_.y && lattice_cell.x < first_.x + width_ &&
         lattice_cell.y < first_.y + height_;
}

std::size_t HitCountingGrid::indexOf(const grid::Cell& lattice_cell) const {
  return static_cast<std::size_t>(lattice_cell.y - first_.y) * static_cast<std::size_t>(width_) +
         static_cast<std::size_t>(lattice_cell.x - first_.x);
}

}  // namespace map_matcher::mapping
