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
constexpr double kMaxLattice = 1e9;  // [cells] farther from the origin an int would overflow

int floorToCell(double coordinate, double resolution) {
  return static_cast<int>(std::clamp(std::floor(coordinate / resolution), -kMaxLattice, kMaxLattice));
}

int ceilToCell(double coordinate, double resolution) {
  // Tolerates the rounding error of a coordinate that is meant to be a multiple of the resolution.
  return static_cast<int>(std::clamp(std::ceil(coordinate / resolution - 1e-9), -kMaxLattice, kMaxLattice));
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
  first_ = {floorToCell(extent.min.x() + 1e-9 * resolution, resolution),
            floorToCell(extent.min.y() + 1e-9 * resolution, resolution)};
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
    drawBeam(fan.origin, beam);
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
    return counts.hits > occupied_threshold * counts.visits ? grid::kOccupied : grid::kFree;
  });
  return grid::OccupancyGrid(geometry, std::move(values));
}

grid::Cell HitCountingGrid::latticeCell(const Eigen::Vector2d& point) const {
  return {floorToCell(point.x(), resolution_), floorToCell(point.y(), resolution_)};
}

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

void HitCountingGrid::drawBeam(const Eigen::Vector2d& origin, const Beam& beam) {
  const auto visit = [this](const grid::Cell& cell, bool hit) {
    Counts& counts = at(cell);
    if (counts.visits == std::numeric_limits<std::uint16_t>::max()) {
      counts = {static_cast<std::uint16_t>(counts.hits / 2), static_cast<std::uint16_t>(counts.visits / 2)};
    }
    ++counts.visits;
    counts.hits = static_cast<std::uint16_t>(counts.hits + (hit ? 1 : 0));
  };
  const grid::Cell end = latticeCell(beam.end);
  grid::Cell cell = latticeCell(origin);
  AxisWalk walk_x(origin.x(), beam.end.x(), resolution_, cell.x);
  AxisWalk walk_y(origin.y(), beam.end.y(), resolution_, cell.y);
  // The number of lines to cross is known in integers, so rounding cannot lead past the last cell.
  for (int lines = std::abs(end.x - cell.x) + std::abs(end.y - cell.y); lines > 0; --lines) {
    visit(cell, false);
    const bool along_x = cell.y == end.y || (cell.x != end.x && walk_x.next < walk_y.next);
    AxisWalk& walk = along_x ? walk_x : walk_y;
    (along_x ? cell.x : cell.y) += walk.step;
    walk.next += walk.period;
  }
  visit(end, beam.hit);
}

HitCountingGrid::Counts& HitCountingGrid::at(const grid::Cell& lattice_cell) {
  const auto column = static_cast<std::size_t>(lattice_cell.x - first_.x);
  const auto row = static_cast<std::size_t>(lattice_cell.y - first_.y);
  return counts_[row * static_cast<std::size_t>(width_) + column];
}

}  // namespace map_matcher::mapping
