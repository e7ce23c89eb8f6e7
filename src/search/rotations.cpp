#include "map_matcher/search/rotations.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher {
double rotationStep(double rotation_downsampling, double diagonal) {
  const double dr = rotation_downsampling / diagonal;  // eq. 4.2
  return 2.0 * M_PI / std::max(1.0, std::ceil(2.0 * M_PI / dr));
}

std::vector<double> allRotations(double rotation_downsampling, double diagonal) {
  const double step = rotationStep(rotation_downsampling, diagonal);
  std::vector<double> angles(static_cast<std::size_t>(std::lround(2.0 * M_PI / step)));
  for (std::size_t n = 0; n < angles.size(); ++n) {
    angles[n] = static_cast<double>(n) * step;
  }
  return angles;
}

std::vector<double> rotationsAround(double centre, double half_width, double step) {
  const int most = static_cast<int>(std::ceil(M_PI / step));
  const int reach = std::min(most, static_cast<int>(std::ceil(half_width / step)));
  std::vector<double> angles{centre};
  for (int k = 1; k <= reach; ++k) {
    angles.push_back(centre - k * step);
    angles.push_back(centre + k * step);
  }
  return angles;
}

namespace {

/// floor() for numbers from -32768 on, in plain arithmetic that compilers turn into vector instructions everywhere.
std::int16_t floorToCell(double value) {
  constexpr int kOffset = 32768;
  return static_cast<std::int16_t>(static_cast<int>(value + kOffset) - kOffset);
}

}  // namespace

RotatedCells rotate(const SessionCells& session, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const std::size_t n = session.points.size();
  RotatedCells cells{std::vector<std::int16_t>(n), std::vector<std::int16_t>(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector2d& p = session.points[k];
    cells.x[k] = floorToCell(c * p.x() - s * p.y());
    cells.y[k] = floorToCell(s * p.x() + c * p.y());
  }
  return cells;
}

}  // namespace map_matcher
