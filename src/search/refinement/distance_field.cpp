#include "map_matcher/search/refinement/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace map_matcher::search {
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

  /// Takes the columns of the walls in a row.
  void setRow(int y, const std::vector<int>& walls) {
    const auto row = along_rows_.begin() + static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(width_);
    std::fill_n(row, width_, static_cast<std::uint16_t>(farthest_ * farthest_));
    for (const int wall : walls) {
      const int last = std::min(wall + farthest_, static_cast<int>(width_) - 1);
      for (int x = std::max(0, wall - farthest_); x <= last; ++x) {
        const auto square = static_cast<std::uint16_t>((x - wall) * (x - wall));
        row[x] = std::min(row[x], square);
      }
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

DistanceField::DistanceField(int width, int height, const std::vector<grid::Cell>& walls, double farthest,
                             const work::Deadline& deadline) {
  const int reach = std::clamp(static_cast<int>(std::ceil(farthest)), 1, kMostCells);
  border_ = reach + 4;  // beyond it, smoothing included, all is flat
  width_ = width + 2 * border_;
  height_ = height + 2 * border_;
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(height_));  // of the walls in each row
  for (const grid::Cell& wall : walls) {
    if (wall.x >= 0 && wall.y >= 0 && wall.x < width && wall.y < height) {
      columns[static_cast<std::size_t>(wall.y + border_)].push_back(wall.x + border_);
    }
  }
  SquaredDistances distances(width_, height_, reach);
  for (int y = 0; y < height_; ++y) {
    deadline.throwIfPassed();
    distances.setRow(y, columns[static_cast<std::size_t>(y)]);
  }
  values_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    deadline.throwIfPassed();
    const std::vector<std::uint16_t>& squares = distances.row(y);
    std::transform(squares.begin(), squares.end(), values_.begin() + std::ptrdiff_t{y} * width_,
                   [](std::uint16_t square) { return 0.5F * static_cast<float>(square); });
  }
  cv::Mat field(height_, width_, CV_32F, values_.data());
  cv::GaussianBlur(field, field, cv::Size(), kSmoothing, kSmoothing, cv::BORDER_REPLICATE);
}

DistanceField::Sample DistanceField::at(const Eigen::Vector2d& position) const {
  const double x = position.x() + border_ - 0.5;
  const double y = position.y() + border_ - 0.5;
  Sample sample;
  if (!(x >= 1.0 && y >= 1.0 && x < width_ - 2 && y < height_ - 2)) {
    return sample;
  }
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double u = x - column;
  const double v = y - row;
  // Of the rows below, at, above and two above the position: interpolated along x, with derivatives along it.
  double value[4];
  double slope[4];
  double bend[2];
  const float* cell = &values_[static_cast<std::size_t>(row - 1) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(column - 1)];
  for (int k = 0; k < 4; ++k, cell += width_) {
    const double steps[3] = {cell[1] - cell[0], cell[2] - cell[1], cell[3] - cell[2]};
    value[k] = cell[1] + u * steps[1];
    slope[k] = 0.5 * ((1.0 - u) * (steps[0] + steps[1]) + u * (steps[1] + steps[2]));
    if (k == 1 || k == 2) {
      bend[k - 1] = (1.0 - u) * (steps[1] - steps[0]) + u * (steps[2] - steps[1]);
    }
  }
  const auto along_y = [v](double lower, double upper) { return (1.0 - v) * lower + v * upper; };
  sample.gradient = {along_y(slope[1], slope[2]), 0.5 * along_y(value[2] - value[0], value[3] - value[1])};
  const double xy = 0.5 * along_y(slope[2] - slope[0], slope[3] - slope[1]);
  const double yy = along_y(value[2] - 2.0 * value[1] + value[0], value[3] - 2.0 * value[2] + value[1]);
  sample.curvature << along_y(bend[0], bend[1]), xy, xy, yy;
  return sample;
}

}  // namespace map_matcher::search
