#include "map_matcher/simulation/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace map_matcher::simulation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHalfDiagonal = 0.708;  // [cells], rounded up: no point of a cell is farther from its centre
constexpr double kClearanceError = 1.7;  // [cells] that clearance() is below the true distance, at most

/// A stride tells how a ray goes on from a cell: kSolid and kOutside end it; kNextCell lets it step to the neighbour it
/// points at; n > kNextCell lets it jump n - kNextCell cells, so far as nothing solid and no border can be nearer.
constexpr std::uint8_t kSolid = 0;
constexpr std::uint8_t kNextCell = 1;
constexpr std::uint8_t kOutside = 255;
constexpr float kLongestStride = 254.0F;

/// The cells of a grid that `blocks` says are in the way, 0 as distanceTransform wants them, within a border of such.
template <typename Predicate>
cv::Mat1b blockedMask(const grid::OccupancyGrid& grid, const Predicate& blocks) {
  cv::Mat1b mask(grid.height() + 2, grid.width() + 2, std::uint8_t{0});
  for (int y = 0; y < grid.height(); ++y) {
    std::uint8_t* row = mask.ptr<std::uint8_t>(y + 1) + 1;
    for (int x = 0; x < grid.width(); ++x) {
      row[x] = blocks(grid.at(x, y)) ? 0 : 255;
    }
  }
  return mask;
}

/// Distance of each cell's centre to the nearest centre of a blocked cell [cells].
cv::Mat1f distancesToBlocked(const cv::Mat1b& mask) {
  cv::Mat1f distances;
  cv::distanceTransform(mask, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return distances;
}

/// Ray parameter [cells] at which a coordinate leaves its cell; infinity when it never does.
double exitOf(double origin, double direction, int cell) {
  if (direction > 0.0) {
    return (cell + 1 - origin) / direction;
  }
  return direction < 0.0 ? (cell - origin) / direction : kInfinity;
}

}  // namespace

World::World(const grid::OccupancyGrid& grid, std::int8_t occupied_threshold)
    : geometry_(grid.geometry()),
      T_grid_map_(geometry_.T_map_grid.inverse()),
      rotation_(T_grid_map_.rotation()),
      padded_width_(grid.width() + 2) {
  if (occupied_threshold < 1 || occupied_threshold > 100) {
    throw std::invalid_argument("occupied_threshold is " + std::to_string(static_cast<int>(occupied_threshold)) +
                                ", expected 1 to 100 percent");
  }
  measureStrides(grid, occupied_threshold);
  measureFreeSpace(grid, occupied_threshold);
}

void World::measureStrides(const grid::OccupancyGrid& grid, std::int8_t occupied_threshold) {
  const auto is_solid = [=](std::int8_t value) { return value >= occupied_threshold; };
  const cv::Mat1f distances = distancesToBlocked(blockedMask(grid, is_solid));
  strides_.assign(distances.total(), kOutside);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const float distance = distances(y + 1, x + 1);
      // Both ends may lie half a diagonal off the centre of their cell.
      const float jump = std::max(0.0F, std::floor(distance - 2.0F * static_cast<float>(kHalfDiagonal)));
      const float stride = distance == 0.0F ? float{kSolid} : std::min(jump + float{kNextCell}, kLongestStride);
      strides_[paddedIndex(x + 1, y + 1)] = static_cast<std::uint8_t>(stride);
    }
  }
}

void World::measureFreeSpace(const grid::OccupancyGrid& grid, std::int8_t occupied_threshold) {
  const auto is_blocked = [=](std::int8_t value) { return value == grid::kUnknown || value >= occupied_threshold; };
  const cv::Mat1f distances = distancesToBlocked(blockedMask(grid, is_blocked));
  free_space_.assign(distances.begin(), distances.end());
}

/// Coordinates in the padded grid [cells].
Eigen::Vector2d World::toCells(const Eigen::Vector2d& p_map) const {
  return ((rotation_ * p_map + T_grid_map_.translation()) / geometry_.resolution).array() + 1.0;
}

/// Whether a point of the padded grid [cells] lies within the grid; NaN does not.
bool World::isInside(const Eigen::Vector2d& p) const {
  return p.x() >= 1.0 && p.y() >= 1.0 && p.x() < geometry_.width + 1 && p.y() < geometry_.height + 1;
}

double World::castRay(const Eigen::Vector2d& p_map, double heading, double range_max) const {
  if (!p_map.allFinite() || !std::isfinite(heading) || !std::isfinite(range_max)) {
    throw std::invalid_argument("a ray from (" + std::to_string(p_map.x()) + ", " + std::to_string(p_map.y()) +
                                ") with heading " + std::to_string(heading) + " and range " +
                                std::to_string(range_max) + ", expected finite numbers");
  }
  const Eigen::Vector2d origin = toCells(p_map);
  if (!isInside(origin)) {
    return kInfinity;
  }
  const double angle = heading - geometry_.T_map_grid.yaw;
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  const double longest = range_max / geometry_.resolution;

  auto x = static_cast<int>(origin.x());
  auto y = static_cast<int>(origin.y());
  double travelled = 0.0;
  while (travelled <= longest) {
    const std::uint8_t stride = strides_[paddedIndex(x, y)];
    if (stride == kSolid || stride == kOutside) {
      return stride == kSolid ? travelled * geometry_.resolution : kInfinity;
    }
    if (stride > kNextCell) {
      travelled += stride - kNextCell;
      x = static_cast<int>(origin.x() + travelled * direction.x());
      y = static_cast<int>(origin.y() + travelled * direction.y());
      continue;
    }
    const double exit_x = exitOf(origin.x(), direction.x(), x);
    const double exit_y = exitOf(origin.y(), direction.y(), y);
    travelled = std::min(exit_x, exit_y);
    (exit_x < exit_y ? x : y) += (exit_x < exit_y ? direction.x() : direction.y()) > 0.0 ? 1 : -1;
  }
  return kInfinity;
}

double World::clearance(const Eigen::Vector2d& p_map) const { return clearanceIn(toCells(p_map)); }

/// The same for a point of the padded grid [cells].
double World::clearanceIn(const Eigen::Vector2d& p) const {
  if (!isInside(p)) {
    return 0.0;
  }
  const auto x = static_cast<int>(p.x());
  const auto y = static_cast<int>(p.y());
  const double from_centre = free_space_[paddedIndex(x, y)];
  const double off_centre = std::hypot(p.x() - x - 0.5, p.y() - y - 0.5);
  return std::max(0.0, from_centre - kHalfDiagonal - off_centre) * geometry_.resolution;
}

bool World::isClear(const Eigen::Vector2d& p_map, double radius) const {
  const Eigen::Vector2d p = toCells(p_map);
  const double certain = clearanceIn(p);
  if (!isInside(p) || certain >= radius || certain + kClearanceError * geometry_.resolution < radius) {
    return isInside(p) && certain >= radius;
  }
  const double reach = radius / geometry_.resolution;
  const int x_last = std::min(static_cast<int>(p.x() + reach), geometry_.width + 1);
  const int y_last = std::min(static_cast<int>(p.y() + reach), geometry_.height + 1);
  for (int y = std::max(0, static_cast<int>(p.y() - reach)); y <= y_last; ++y) {
    for (int x = std::max(0, static_cast<int>(p.x() - reach)); x <= x_last; ++x) {
      const double dx = std::max({x - p.x(), 0.0, p.x() - (x + 1)});
      const double dy = std::max({y - p.y(), 0.0, p.y() - (y + 1)});
      if (isBlocked(x, y) && std::hypot(dx, dy) < reach) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace map_matcher::simulation
