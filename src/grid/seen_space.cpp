#include "map_matcher/grid/seen_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "map_matcher/grid/occupied_cells.hpp"

namespace map_matcher::grid {
namespace {

/// The cells within `distance` [cells] of a wall, which are not 0.
cv::Mat widened(const cv::Mat& walls, double distance) {
  cv::Mat distances;  // with no wall at all they are very large
  cv::distanceTransform(walls == 0, distances, cv::DIST_L2, cv::DIST_MASK_5);
  return distances <= distance;
}

/// The cells on the middle lines of walls, or `deepest` [cells] below the surface of thicker ones.
std::vector<Cell> middleLines(const cv::Mat& walls, double deepest) {
  cv::Mat depth;
  cv::distanceTransform(walls, depth, cv::DIST_L2, cv::DIST_MASK_5);
  cv::Mat deepest_around;
  cv::dilate(depth, deepest_around, cv::Mat(), cv::Point(-1, -1), 1, cv::BORDER_REPLICATE);
  std::vector<Cell> cells;
  for (int y = 0; y < walls.rows; ++y) {
    for (int x = 0; x < walls.cols; ++x) {
      const float here = depth.at<float>(y, x);
      const bool is_ridge = here > 0.0F && here >= deepest_around.at<float>(y, x) && here < deepest;
      if (is_ridge || (here >= deepest && here < deepest + 1.0)) {
        cells.push_back({x, y});
      }
    }
  }
  return cells;
}

}  // namespace

SeenSpace::SeenSpace(const OccupancyGrid& map, double cell_offset, int occupied_threshold) : geometry_(map.geometry()) {
  geometry_.T_map_grid = cornerOf(map.geometry(), cell_offset);
  cv::Mat walls(geometry_.height, geometry_.width, CV_8U, cv::Scalar(0));
  for (const Cell& wall : occupiedCells(map, static_cast<std::int8_t>(occupied_threshold))) {
    walls.at<std::uint8_t>(wall.y, wall.x) = 1;
  }
  const cv::Mat near = widened(walls, kNear / geometry_.resolution);
  seen_.reserve(walls.total());
  for (int y = 0; y < geometry_.height; ++y) {
    for (int x = 0; x < geometry_.width; ++x) {
      const std::int8_t value = map.at(x, y);
      const bool is_free = value >= 0 && value <= 100 - occupied_threshold;
      seen_.push_back(near.at<std::uint8_t>(y, x) != 0 ? Seen::kNearWall : is_free ? Seen::kOpen : Seen::kUnseen);
    }
  }
  for (const Cell& cell : middleLines(walls, std::max(1.0, kNear / geometry_.resolution))) {
    walls_.push_back(geometry_.cellCentre(cell));
  }
}

Seen SeenSpace::at(const Eigen::Vector2d& p_map) const {
  const Cell cell = geometry_.cellAt(p_map);
  if (!geometry_.contains(cell)) {
    return Seen::kUnseen;
  }
  return seen_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(geometry_.width) +
               static_cast<std::size_t>(cell.x)];
}

}  // namespace map_matcher::grid
