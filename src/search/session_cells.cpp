#include "map_matcher/search/session_cells.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <utility>

namespace map_matcher {
namespace {

struct Box {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
};

Box boundingBox(const std::vector<Cell>& cells) {
  Cell low = cells.front();
  Cell high = cells.front();
  for (const Cell& cell : cells) {
    low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
    high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
  }
  return {{low.x, low.y}, {high.x + 1.0, high.y + 1.0}};
}

/// One cell for all that fall into the same cell of `ratio` times the size.
std::vector<Cell> merged(std::vector<Cell> cells, double ratio) {
  for (Cell& cell : cells) {
    cell = {static_cast<int>(std::floor((cell.x + 0.5) / ratio)), static_cast<int>(std::floor((cell.y + 0.5) / ratio))};
  }
  const auto row_by_row = [](const Cell& a, const Cell& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); };
  std::sort(cells.begin(), cells.end(), row_by_row);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// Fisher-Yates with a fixed seed. std::shuffle may differ between standard libraries.
void shuffle(std::vector<Eigen::Vector2d>& points) {
  std::mt19937 random;  // its default seed
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random() % i]);
  }
}

}  // namespace

SessionCells prepareSessionCells(const std::vector<Cell>& cells, double map_resolution, double resolution,
                                 CellMerging merging, int sample_threshold) {
  const double ratio = resolution / map_resolution;
  const bool merge = merging == CellMerging::kMerge;
  const double cell_size = merge ? ratio : 1.0;  // of a point's cell, in cells of the map

  const Box box = boundingBox(cells);
  const Eigen::Vector2d centre = 0.5 * (box.low + box.high);
  const Eigen::Vector2d size = (box.high - box.low) / ratio;

  SessionCells session;
  session.resolution = resolution;
  session.centre = centre * map_resolution;
  session.diagonal = size.norm();
  session.longest_side = static_cast<int>(std::ceil(size.maxCoeff()));
  for (const Cell& cell : merge ? merged(cells, ratio) : cells) {
    const Eigen::Vector2d middle = Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5) * cell_size;
    session.points.emplace_back((middle - centre) / ratio);
  }
  shuffle(session.points);
  if (sample_threshold > 0 && session.points.size() > static_cast<std::size_t>(sample_threshold)) {
    session.points.resize(static_cast<std::size_t>(sample_threshold));
  }
  return session;
}

}  // namespace map_matcher
