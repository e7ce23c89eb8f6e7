#include "map_matcher/search/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace map_matcher {
namespace {

constexpr double kSmoothing = 1.0;  // standard deviation [cells]
constexpr int kMostCells = 150;     // that a distance is told up to, so that its square fits 16 bits

/// Squared distances to the nearest wall, up to a largest one, in two passes: along the rows, then along the columns.
/// Where only short distances matter this takes a tenth of the time of a general distance transform.
class SquaredDistances {
 public:
  SquaredDistances(int width, int height, int farthest)
      : width_(static_cast<std::size_t>(width)),
        height_(height),
        farthest_(farthest),
        along_rows_(width_ * static_cast<std::size_t>(height)),
        nearest_(width_) {}

  /// Takes the walls of a row.
  void setRow(int y, const std::uint8_t* walls) {
    std::uint16_t* squares = &along_rows_[static_cast<std::size_t>(y) * width_];
    int distance = farthest_;
    for (std::size_t x = 0; x < width_; ++x) {
      distance = walls[x] != 0 ? 0 : std::min(distance + 1, farthest_);
      squares[x] = static_cast<std::uint16_t>(distance);
    }
    distance = farthest_;
    for (std::size_t x = width_; x-- > 0;) {
      distance = std::min<int>(distance + 1, squares[x]);
      squares[x] = static_cast<std::uint16_t>(distance * distance);
    }
  }

  /// The squared distances in a row, once all rows are set.
  const std::vector<std::uint16_t>& row(int y) {
    const int largest = farthest_ * farthest_;
    std::fill(nearest_.begin(), nearest_.end(), static_cast<std::uint16_t>(largest));
    for (int other = std::max(0, y - farthest_); other <= std::min(height_ - 1, y + farthest_); ++other) {
      const auto square = static_cast<std::uint16_t>((other - y) * (other - y));
      const std::uint16_t* squares = &along_rows_[static_cast<std::size_t>(other) * width_];
      for (std::size_t x = 0; x < width_; ++x) {
        const auto sum = static_cast<std::uint16_t>(squares[x] + square);
        nearest_[x] = sum < nearest_[x] ? sum : nearest_[x];
      }
    }
    return nearest_;
  }

 private:
  std::size_t width_;
  int height_;
  int farthest_;
  std::vector<std::uint16_t> along_rows_;
  std::vector<std::uint16_t> nearest_;
};

}  // namespace

DistanceField::DistanceField(const PrecomputedGrids& walls, const Cell& first, const Cell& last, double farthest)
    : first_(first), width_(std::max(4, last.x - first.x + 1)), height_(std::max(4, last.y - first.y + 1)) {
  const int reach = std::clamp(static_cast<int>(std::ceil(farthest)), 1, kMostCells);
  SquaredDistances distances(width_, height_, reach);
  std::vector<std::uint8_t> wall_row(static_cast<std::size_t>(width_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      wall_row[static_cast<std::size_t>(x)] = walls.level(0).at(first.x + x, first.y + y);
    }
    distances.setRow(y, wall_row.data());
  }
  values_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    const std::vector<std::uint16_t>& squares = distances.row(y);
    std::transform(squares.begin(), squares.end(), values_.begin() + std::ptrdiff_t{y} * width_,
                   [](std::uint16_t square) { return 0.5F * static_cast<float>(square); });
  }
  cv::Mat field(height_, width_, CV_32F, values_.data());
  cv::GaussianBlur(field, field, cv::Size(), kSmoothing, kSmoothing, cv::BORDER_REPLICATE);
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
