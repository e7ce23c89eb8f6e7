#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "map_matcher/grid/chamfer_distances.hpp"
#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/grid/seen_space.hpp"

namespace map_matcher::grid {
namespace {

/// Walls, thick and thin, some on the edge, and single cells in free and unknown space.
OccupancyGrid randomMap(std::mt19937& generator, double resolution) {
  const auto between = [&generator](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator);
  };
  OccupancyGrid map({resolution, between(1, 70), between(1, 60), {0.3, -0.2, 0.1}});
  const auto fill = [&](int width, int height, std::int8_t value) {
    const int left = between(-3, map.width());
    const int low = between(-3, map.height());
    for (int y = std::max(low, 0); y < std::min(low + height, map.height()); ++y) {
      for (int x = std::max(left, 0); x < std::min(left + width, map.width()); ++x) {
        map.at(x, y) = value;
      }
    }
  };
  fill(between(10, 60), between(10, 60), kFree);
  for (int i = between(0, 6); i > 0; --i) {
    fill(between(1, 40), between(1, 4), kOccupied);
    fill(between(1, 3), between(1, 40), kOccupied);
  }
  if (between(0, 3) == 0) {
    fill(between(20, 60), between(20, 60), kOccupied);
  }
  for (int i = between(0, 30); i > 0; --i) {
    fill(1, 1, kOccupied);
  }
  return map;
}

cv::Mat1b wallsOf(const OccupancyGrid& map) {
  cv::Mat1b walls(map.height(), map.width(), static_cast<std::uint8_t>(0));
  for (const Cell& wall : occupiedCells(map, kDefaultOccupiedThreshold)) {
    walls(wall.y, wall.x) = 1;
  }
  return walls;
}

cv::Mat1f transformOf(const cv::Mat1b& not_zero) {
  cv::Mat1f distances;
  cv::distanceTransform(not_zero, distances, cv::DIST_L2, cv::DIST_MASK_5);
  return distances;
}

TEST(ChamferDepths, AreThoseOfTheTransformOfTheWholeGrid) {
  std::mt19937 generator(20261125);
  for (int trial = 0; trial < 400; ++trial) {
    const OccupancyGrid map = randomMap(generator, 0.05);
    const double deepest = std::uniform_real_distribution<double>(1.0, 12.0)(generator);
    const cv::Mat1f expected = transformOf(wallsOf(map));

    const ChamferDepths depths(occupiedCells(map, kDefaultOccupiedThreshold), deepest, map.width(), map.height());

    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        if (expected(y, x) <= deepest) {
          ASSERT_EQ(depths.at({x, y}), static_cast<double>(expected(y, x))) << trial << ": " << x << ", " << y;
        } else {
          ASSERT_TRUE(std::isinf(depths.at({x, y}))) << trial << ": " << x << ", " << y;
        }
      }
    }
  }
}

/// SeenSpace with transforms of the whole grid: what is near walls, and where walls stand.
TEST(SeenSpaceOfRandomMaps, IsThatOfTheTransformsOfTheWholeGrid) {
  std::mt19937 generator(42);
  for (int trial = 0; trial < 400; ++trial) {
    const double resolution = std::vector<double>{0.02, 0.05, 0.07, 0.25}[static_cast<std::size_t>(trial % 4)];
    const OccupancyGrid map = randomMap(generator, resolution);
    const cv::Mat1b walls = wallsOf(map);
    const cv::Mat1f far = transformOf(cv::Mat1b(walls == 0));
    const cv::Mat1f depth = transformOf(walls);
    cv::Mat1f around;
    cv::dilate(depth, around, cv::Mat(), cv::Point(-1, -1), 1, cv::BORDER_REPLICATE);
    const double deepest = std::max(1.0, SeenSpace::kNear / resolution);

    const SeenSpace space(map, 0.0, kDefaultOccupiedThreshold);

    std::vector<Eigen::Vector2d> lines;
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const bool is_near = far(y, x) <= SeenSpace::kNear / resolution;
        const Seen expected = is_near ? Seen::kNearWall : map.at(x, y) == kFree ? Seen::kOpen : Seen::kUnseen;
        ASSERT_EQ(space.at(map.geometry().cellCentre({x, y})), expected) << trial << ": " << x << ", " << y;
        const double here = depth(y, x);
        if ((here > 0.0 && here >= around(y, x) && here < deepest) || (here >= deepest && here < deepest + 1.0)) {
          lines.push_back(map.geometry().cellCentre({x, y}));
        }
      }
    }
    ASSERT_EQ(space.walls(), lines) << trial;
  }
}

}  // namespace
}  // namespace map_matcher::grid
