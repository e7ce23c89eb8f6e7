/// \file
/// Maps in which a room comes again at other places and headings, so that the best place has runners-up as good as it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "map_matcher/grid/grid_geometry.hpp"
#include "map_matcher/grid/rigid2.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::test {

/// Cells of a square of `size`, turned about its middle and moved to `middle` [cells]; quarter turns are exact.
inline std::vector<grid::Cell> turnedCopy(const std::vector<grid::Cell>& room, int size, double angle,
                                          const Eigen::Vector2d& middle) {
  const Eigen::Matrix2d R = grid::Rigid2{0.0, 0.0, angle}.rotation();
  std::vector<grid::Cell> copy;
  for (const grid::Cell& cell : room) {
    const Eigen::Vector2d p = R * (Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5).array() - 0.5 * size).matrix() + middle;
    copy.push_back({static_cast<int>(std::floor(p.x() + 1e-9)), static_cast<int>(std::floor(p.y() + 1e-9))});
  }
  return copy;
}

/// A quarter turn, half a turn or three quarters in two cases of three, else any angle [rad].
inline double randomTurn(std::mt19937& random) {
  return random() % 3 == 0 ? randomReal(random, -3.0, 3.0) : M_PI / 2.0 * randomInt(random, 1, 3);
}

/// Leaves out each cell with a chance of `percent` in a hundred.
inline std::vector<grid::Cell> thinned(std::mt19937& random, std::vector<grid::Cell> cells, int percent) {
  cells.erase(
      std::remove_if(cells.begin(), cells.end(), [&](const grid::Cell&) { return randomInt(random, 0, 99) < percent; }),
      cells.end());
  return cells;
}

}  // namespace map_matcher::test
