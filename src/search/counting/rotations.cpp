#include "map_matcher/search/counting/rotations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vector_clones.hpp"

namespace map_matcher::search {

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

/// floor() of the turned points, for results from -32768 on. Adding an offset and truncating is what compilers turn
/// into vector instructions everywhere.
MAP_MATCHER_VECTOR_CLONES
void turnToCells(const Eigen::Vector2d* points, std::size_t size, double cosine, double sine, std::int16_t* x,
                 std::int16_t* y) {
  constexpr int kOffset = 32768;
  for (std::size_t k = 0; k < size; ++k) {
    const double* p = points[k].data();
    const double turned_x = cosine * p[0] - sine * p[1];
    const double turned_y = sine * p[0] + cosine * p[1];
    x[k] = static_cast<std::int16_t>(static_cast<int>(turned_x + kOffset) - kOffset);
    y[k] = static_cast<std::int16_t>(static_cast<int>(turned_y + kOffset) - kOffset);
  }
}

}  // namespace

RotatedCells rotate(const SessionCells& session, double angle) {
  const std::size_t size = session.points.size();
  RotatedCells cells{std::vector<std::int16_t>(size), std::vector<std::int16_t>(size)};
  turnToCells(session.points.data(), size, std::cos(angle), std::sin(angle), cells.x.data(), cells.y.data());
  return cells;
}

}  // namespace map_matcher::search
