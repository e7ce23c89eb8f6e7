#include "map_matcher/evaluation/map_changes.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "map_matcher/grid/near_walls.hpp"
#include "map_matcher/grid/occupied_cells.hpp"
#include "picture_file.hpp"

namespace map_matcher::evaluation {
namespace {

constexpr double kMargin = 1.0;      // around walls [m]
constexpr int kWantedPixels = 1000;  // along the longer side, at least
const cv::Vec3b kKept(60, 60, 60);   // BGR
const cv::Vec3b kGone(0, 0, 230);
const cv::Vec3b kNew(0, 160, 0);
const cv::Vec3b kUnseen(150, 150, 150);
const cv::Vec3b kFree(255, 255, 255);
const cv::Vec3b kUnknown(215, 215, 215);

/// One of the two maps, asked for in the older map's frame.
class PlacedMap {
 public:
  PlacedMap(const grid::OccupancyGrid& map, const grid::Rigid2& T_before_map, double tolerance)
      : map_(map), T_before_map_(T_before_map), T_map_before_(T_before_map.inverse()), near_(map, tolerance) {}

  /// The value at a place [m]; unknown outside the map.
  std::int8_t at(const Eigen::Vector2d& p_before) const {
    const grid::Cell cell = map_.geometry().cellAt(T_map_before_ * p_before);
    return map_.geometry().contains(cell) ? map_.at(cell.x, cell.y) : grid::kUnknown;
  }

  bool isNearWall(const Eigen::Vector2d& p_before) const { return near_.isNearWall(T_map_before_ * p_before); }

  std::vector<Eigen::Vector2d> walls() const {
    std::vector<Eigen::Vector2d> places;
    for (const grid::Cell& cell : grid::occupiedCells(map_)) {
      places.emplace_back(T_before_map_ * map_.geometry().cellCentre(cell));
    }
    return places;
  }

 private:
  const grid::OccupancyGrid& map_;
  grid::Rigid2 T_before_map_;
  grid::Rigid2 T_map_before_;
  grid::NearWalls near_;
};

/// The colour of a wall of one map, by what the other one has there.
cv::Vec3b wallColour(const PlacedMap& other, const Eigen::Vector2d& place, const cv::Vec3b& otherwise) {
  if (other.isNearWall(place)) {
    return kKept;
  }
  return other.at(place) == grid::kUnknown ? kUnseen : otherwise;
}

cv::Vec3b colourAt(const PlacedMap& before, const PlacedMap& after, const Eigen::Vector2d& place) {
  if (before.at(place) >= grid::kDefaultOccupiedThreshold) {
    return wallColour(after, place, kGone);
  }
  if (after.at(place) >= grid::kDefaultOccupiedThreshold) {
    return wallColour(before, place, kNew);
  }
  const bool is_known = before.at(place) != grid::kUnknown || after.at(place) != grid::kUnknown;
  return is_known ? kFree : kUnknown;
}

/// The grid of the picture's pixels in the older map's frame: its axes, all walls of both, and a margin.
grid::GridGeometry pixelsOf(const PlacedMap& before, const PlacedMap& after, const grid::Rigid2& T_before_grid,
                            double resolution) {
  const grid::Rigid2 T_grid_before = T_before_grid.inverse();
  Eigen::Vector2d low(0.0, 0.0);
  Eigen::Vector2d high(0.0, 0.0);
  bool is_first = true;
  for (const PlacedMap* map : {&before, &after}) {
    for (const Eigen::Vector2d& wall : map->walls()) {
      const Eigen::Vector2d p = T_grid_before * wall;
      low = is_first ? p : low.cwiseMin(p);
      high = is_first ? p : high.cwiseMax(p);
      is_first = false;
    }
  }
  const double left = std::floor((low.x() - kMargin) / resolution) * resolution;  // in step with the older map's cells
  const double bottom = std::floor((low.y() - kMargin) / resolution) * resolution;
  grid::GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = static_cast<int>(std::ceil((high.x() + kMargin - left) / resolution));
  geometry.height = static_cast<int>(std::ceil((high.y() + kMargin - bottom) / resolution));
  geometry.T_map_grid = T_before_grid * grid::Rigid2{left, bottom, 0.0};
  return geometry;
}

}  // namespace

MapChanges mapChanges(const grid::OccupancyGrid& before, const grid::OccupancyGrid& after,
                      const grid::Rigid2& T_before_after, double tolerance) {
  return {mapQuality(after, before, T_before_after.inverse(), tolerance),
          mapQuality(before, after, T_before_after, tolerance)};
}

void writeChangesImage(const std::string& path, const grid::OccupancyGrid& before, const grid::OccupancyGrid& after,
                       const grid::Rigid2& T_before_after, double tolerance) {
  const PlacedMap older(before, {}, tolerance);
  const PlacedMap newer(after, T_before_after, tolerance);
  const grid::GridGeometry pixels =
      pixelsOf(older, newer, before.geometry().T_map_grid, std::min(before.resolution(), after.resolution()));
  cv::Mat image(pixels.height, pixels.width, CV_8UC3);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      image.at<cv::Vec3b>(row, column) = colourAt(older, newer, pixels.cellCentre({column, image.rows - 1 - row}));
    }
  }
  const int longer = std::max(image.rows, image.cols);
  const int scale = std::max(1, (kWantedPixels + longer - 1) / longer);
  cv::Mat enlarged;
  cv::resize(image, enlarged, cv::Size(), scale, scale, cv::INTER_NEAREST);
  writePicture(path, enlarged);
}

}  // namespace map_matcher::evaluation
