#include "map_matcher/grid/near_walls.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "map_matcher/grid/occupied_cells.hpp"

namespace map_matcher::grid {

NearWalls::NearWalls(const OccupancyGrid& map, double distance, std::int8_t occupied_threshold)
    : geometry_(map.geometry()) {
  if (!(std::isfinite(distance) && distance >= 0.0)) {
    throw std::invalid_argument("distance is " + std::to_string(distance) + ", expected at least 0 m");
  }
  cv::Mat free(geometry_.height, geometry_.width, CV_8U, cv::Scalar(1));
  for (const Cell& wall : occupiedCells(map, occupied_threshold)) {
    free.at<std::uint8_t>(wall.y, wall.x) = 0;
  }
  cv::Mat distances;  // [cells]; with no wall at all they are very large
  cv::distanceTransform(free, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  near_wall_.reserve(free.total());
  for (int y = 0; y < geometry_.height; ++y) {
    for (int x = 0; x < geometry_.width; ++x) {
      const double metres = static_cast<double>(distances.at<float>(y, x)) * geometry_.resolution;
      near_wall_.push_back(metres <= distance ? 1 : 0);
    }
  }
}

bool NearWalls::isNearWall(const Eigen::Vector2d& p_map) const {
  if (!p_map.allFinite()) {
    return false;
  }
  const Cell cell = geometry_.cellAt(p_map);
  return geometry_.contains(cell) &&
         near_wall_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(geometry_.width) +
                    static_cast<std::size_t>(cell.x)] != 0;
}

}  // namespace map_matcher::grid
