#include "map_matcher/search/rotation_blocks.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace map_matcher {
namespace {

/// Added to half of the arc for the rounding of single precision, which is below 0.01 cells for kMaxSessionDiagonal.
/// The arc is a whole number and a half, so that its ceiling, BlockShape::arc(), has room for twice this.
constexpr float kRounding = 0.02F;

double farthestPoint(const SessionCells& session) {
  double farthest = 0.0;
  for (const Eigen::Vector2d& p : session.points) {
    farthest = std::max(farthest, p.norm());
  }
  return farthest;
}

/// floor() of a number from -32768 on, in plain arithmetic that compilers turn into vector instructions everywhere.
std::int16_t floorToCell(float value) {
  const int truncated = static_cast<int>(value);
  return static_cast<std::int16_t>(truncated - (static_cast<float>(truncated) > value ? 1 : 0));
}

}  // namespace

RotationBlocks::RotationBlocks(const SessionCells& session, double first_angle, double step, int count)
    : session_(session), first_angle_(first_angle), step_(step), count_(count) {
  const double farthest = farthestPoint(session);
  if (!(step > 0.0 && step * farthest <= 0.5)) {
    throw std::invalid_argument("a rotation step of " + std::to_string(step) + " rad moves a session cell by " +
                                std::to_string(step * farthest) + " cells, expected at most 0.5");
  }
  for (const Eigen::Vector2d& p : session.points) {
    x_.push_back(static_cast<float>(p.x()));
    y_.push_back(static_cast<float>(p.y()));
  }
}

WeightedCells RotationBlocks::cells(const BlockShape& shape, int first_rotation, CellMerger& merger) const {
  if (shape.level == 0) {
    return merger.merge(rotate(session_, angle(first_rotation)), 1);
  }
  const double middle = angle(first_rotation) + 0.5 * (shape.stride() - 1) * step_;
  return merger.merge(lowerCorners(shape, middle), shape.merged());
}

RotatedCells RotationBlocks::lowerCorners(const BlockShape& shape, double middle) const {
  const auto c = static_cast<float>(std::cos(middle));
  const auto s = static_cast<float>(std::sin(middle));
  const float back = static_cast<float>(shape.halfArc()) + kRounding;
  const std::size_t n = x_.size();
  RotatedCells cells{std::vector<std::int16_t>(n), std::vector<std::int16_t>(n)};
  for (std::size_t k = 0; k < n; ++k) {
    cells.x[k] = floorToCell(c * x_[k] - s * y_[k] - back);
    cells.y[k] = floorToCell(s * x_[k] + c * y_[k] - back);
  }
  return cells;
}

}  // namespace map_matcher
