#include "map_matcher/search/distance_field.hpp"

#include <cmath>
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
  cv::distanceTransform(walls, field, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::min(field, farthest, field);
  cv::multiply(field, field, field, 0.5);
  cv::GaussianBlur(field, field, cv::Size(), kSmoothing, kSmoothing, cv::BORDER_REPLICATE);
  return field;
}

}  // namespace

DistanceField::DistanceField(const PrecomputedGrids& walls, const Cell& first, const Cell& last, double farthest)
    : first_(first), width_(std::max(3, last.x - first.x + 1)), height_(std::max(3, last.y - first.y + 1)) {
  const cv::Mat field = smoothField(wallImage(walls, first, width_, height_), farthest);
  nodes_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Node{});
  for (int y = 1; y + 1 < height_; ++y) {
    const auto* below = field.ptr<float>(y - 1);
    const auto* here = field.ptr<float>(y);
    const auto* above = field.ptr<float>(y + 1);
    Node* nodes = &nodes_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)];
    for (int x = 1; x + 1 < width_; ++x) {
      nodes[x] = {
          0.5F * (here[x + 1] - here[x - 1]), 0.5F * (above[x] - below[x]), here[x + 1] - 2.0F * here[x] + here[x - 1],
          0.25F * (above[x + 1] - above[x - 1] - below[x + 1] + below[x - 1]), above[x] - 2.0F * here[x] + below[x]};
    }
  }
}

DistanceField::Sample DistanceField::at(const Eigen::Vector2d& position) const {
  const double x = position.x() - first_.x - 0.5;
  const double y = position.y() - first_.y - 0.5;
  Sample sample;
  if (!(x >= 0.0 && y >= 0.0 && x < width_ - 1 && y < height_ - 1)) {
    return sample;
  }
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double u = x - column;
  const double v = y - row;
  const Node* lower =
      &nodes_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
  const Node* upper = lower + width_;
  const auto between = [&](std::size_t k) {
    return (1.0 - v) * ((1.0 - u) * lower[0][k] + u * lower[1][k]) + v * ((1.0 - u) * upper[0][k] + u * upper[1][k]);
  };
  sample.gradient = {between(0), between(1)};
  sample.curvature << between(2), between(3), between(3), between(4);
  return sample;
}

}  // namespace map_matcher
