#include "map_matcher/simulation/rectangle.hpp"

#include <algorithm>

namespace map_matcher::simulation {

bool contains(const Rectangle& rectangle, const Eigen::Vector2d& p) {
  return p.x() >= rectangle.x_min && p.x() <= rectangle.x_max && p.y() >= rectangle.y_min && p.y() <= rectangle.y_max;
}

double separation(const Rectangle& a, const Rectangle& b) {
  const double apart_x = std::max(a.x_min - b.x_max, b.x_min - a.x_max);
  const double apart_y = std::max(a.y_min - b.y_max, b.y_min - a.y_max);
  return std::max(apart_x, apart_y);
}

}  // namespace map_matcher::simulation
