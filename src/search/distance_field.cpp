#include "map_matcher/search/distance_field.hpp"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace map_matcher {
namespace {

constexpr double kSmoothing = 1.0;  // standard deviation [cells]

/// Walls as zeros.
cv::Mat wallImage(const PrecomputedGrids& walls, const Cell& first, int width, int height) {
  cv::Mat image(height, width, CV_8U);
  for (int y = 0; y < height; ++y) {
    auto* row = image.ptr<std::uint8_t>(y);
    for (int x = 0; x < width; ++x) {
      row[x] = walls.level(0).at(first.x + x, first.y + y) != 0 ? 0 : 1;
    }
  }
  return image;
}

/// Half the squared distance to the nearest wall, smoothed.
cv::Mat smoothField(const cv::Mat& walls, double farthest) {
  cv::Mat field;
  cv::distanceTransform(walls, field, cv::DIST_L2, cv::DIST_MASK_5);
  cv::min(field, farthest, field);
  cv::multiply(field, field, field, 0.5);
  cv::GaussianBlur(field, field, cv::Size(), kSmoothing, kSmoothing, cv::BORDER_REPLICATE);
  return field;
}

}  // namespace

DistanceField::DistanceField(const PrecomputedGrids& walls, const Cell& first, const Cell& last, double farthest)
    : first_(first), width_(std::max(4, last.x - first.x + 1)), height_(std::max(4, last.y - first.y + 1)) {
  const cv::Mat field = smoothField(wallImage(walls, first, width_, height_), farthest);
  values_.assign(field.begin<float>(), field.end<float>());
}

DistanceField::Sample DistanceField::at(const Eigen::Vector2d& position) const {
  const double x = position.x() - first_.x - 0.5;
  const double y = position.y() - first_.y - 0.5;
  Sample sample;
  if (!(x >= 1.0 && y >= 1.0 && x < width_ - 2 && y < height_ - 2)) {
    return sample;
  }
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double u = x - column;
  const double v = y - row;
  const Derivatives derivatives =
      (1.0 - v) * ((1.0 - u) * derivativesAt(column, row) + u * derivativesAt(column + 1, row)) +
      v * ((1.0 - u) * derivativesAt(column, row + 1) + u * derivativesAt(column + 1, row + 1));
  sample.gradient = derivatives.head<2>();
  sample.curvature << derivatives[2], derivatives[3], derivatives[3], derivatives[4];
  return sample;
}

DistanceField::Derivatives DistanceField::derivativesAt(int column, int row) const {
  const float* here =
      &values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
  const float* below = here - width_;
  const float* above = here + width_;
  Derivatives derivatives;
  derivatives << 0.5F * (here[1] - here[-1]), 0.5F * (above[0] - below[0]), here[1] - 2.0F * here[0] + here[-1],
      0.25F * (above[1] - above[-1] - below[1] + below[-1]), above[0] - 2.0F * here[0] + below[0];
  return derivatives;
}

}  // namespace map_matcher
