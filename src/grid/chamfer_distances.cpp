#include "map_matcher/grid/chamfer_distances.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace map_matcher::grid {
namespace {

/// Cells that may be looked at, for each of the grid, before the whole transform costs less.
constexpr double kWorthwhile = 20.0;

/// A cell as seen from another one.
struct Offset {
  int x = 0;
  int y = 0;
  float distance = 0.0F;  // [cells]
};

cv::Mat1f distancesFrom(const cv::Mat1b& not_zero) {
  cv::Mat1f distances;
  cv::distanceTransform(not_zero, distances, cv::DIST_L2, cv::DIST_MASK_5);
  return distances;
}

/// Those within `distance`, the nearest first.
std::vector<Offset> offsetsWithin(double distance) {
  const int reach = static_cast<int>(distance);
  cv::Mat1b mask(2 * reach + 1, 2 * reach + 1, static_cast<std::uint8_t>(1));
  mask(reach, reach) = 0;
  const cv::Mat1f distances = distancesFrom(mask);
  std::vector<Offset> offsets;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (distances(y, x) <= distance) {
        offsets.push_back({x - reach, y - reach, distances(y, x)});
      }
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(),
                   [](const Offset& a, const Offset& b) { return a.distance < b.distance; });
  return offsets;
}

}  // namespace

std::vector<int> chamferDisc(double distance) {
  std::vector<int> half_widths(2 * static_cast<std::size_t>(distance) + 1, 0);
  const int reach = static_cast<int>(distance);
  for (const Offset& offset : offsetsWithin(distance)) {
    int& half_width = half_widths[static_cast<std::size_t>(offset.y + reach)];
    half_width = std::max(half_width, offset.x);
  }
  return half_widths;
}

ChamferDepths::ChamferDepths(const std::vector<Cell>& walls, double deepest, int width, int height)
    : width_(width), height_(height), ranks_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {
  const std::vector<Offset> offsets = offsetsWithin(deepest);
  std::vector<std::uint16_t> rank_of(offsets.size());
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (i == 0 || offsets[i].distance > offsets[i - 1].distance) {
      depths_.push_back(offsets[i].distance);
    }
    rank_of[i] = static_cast<std::uint16_t>(depths_.size() - 1);
  }
  depths_.push_back(std::numeric_limits<double>::infinity());
  for (const Cell& wall : walls) {
    ranks_[index(wall)] = infinite();
  }
  if (static_cast<double>(walls.size()) * static_cast<double>(offsets.size()) >
      kWorthwhile * static_cast<double>(ranks_.size())) {
    rankByTransform(walls);
    return;
  }
  for (const Cell& wall : walls) {
    const auto free = std::find_if(offsets.begin(), offsets.end(), [&](const Offset& offset) {
      const Cell cell{wall.x + offset.x, wall.y + offset.y};
      return cell.x >= 0 && cell.y >= 0 && cell.x < width && cell.y < height && ranks_[index(cell)] == 0;
    });
    if (free != offsets.end()) {
      ranks_[index(wall)] = rank_of[static_cast<std::size_t>(free - offsets.begin())];
    }
  }
}

void ChamferDepths::rankByTransform(const std::vector<Cell>& walls) {
  cv::Mat1b mask(height_, width_, static_cast<std::uint8_t>(0));
  for (const Cell& wall : walls) {
    mask(wall.y, wall.x) = 1;
  }
  const cv::Mat1f distances = distancesFrom(mask);
  for (const Cell& wall : walls) {
    const auto depth = std::lower_bound(depths_.begin(), depths_.end() - 1, distances(wall.y, wall.x));
    ranks_[index(wall)] = static_cast<std::uint16_t>(depth - depths_.begin());
  }
}

double ChamferDepths::deepestAround(const Cell& cell) const {
  std::uint16_t rank = 0;
  for (int y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, height_ - 1); ++y) {
    for (int x = std::max(cell.x - 1, 0); x <= std::min(cell.x + 1, width_ - 1); ++x) {
      rank = std::max(rank, ranks_[index({x, y})]);
    }
  }
  return depths_[rank];
}

}  // namespace map_matcher::grid
