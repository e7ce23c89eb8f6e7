#include "map_matcher/grid/resample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::grid {
namespace {

/// Old cells [first, last) that a new cell overlaps along one axis.
struct Span {
  int first;
  int last;
};

/// Edges that agree within this share of a cell are the same edge: 0.1 / 0.05 must not touch a third cell.
constexpr double kEdgeTolerance = 1e-6;

int newSize(int old_size, double ratio) {
  const double size = std::max(1.0, std::ceil(old_size / ratio - kEdgeTolerance));
  if (size > std::numeric_limits<int>::max()) {
    throw std::invalid_argument("a resolution " + parameters::numberText(1.0 / ratio) + " times as fine makes " +
                                parameters::numberText(size) + " cells a side, expected at most " +
                                std::to_string(std::numeric_limits<int>::max()));
  }
  return static_cast<int>(size);
}

std::vector<Span> overlaps(int old_size, int new_size, double ratio) {
  std::vector<Span> spans;
  spans.reserve(static_cast<std::size_t>(new_size));
  for (int i = 0; i < new_size; ++i) {
    const int first = static_cast<int>(std::floor(i * ratio + kEdgeTolerance));
    const int last = static_cast<int>(std::min<double>(old_size, std::ceil((i + 1) * ratio - kEdgeTolerance)));
    spans.push_back({std::min(first, old_size - 1), std::clamp(last, first + 1, old_size)});
  }
  spans.back().last = old_size;  // whatever the rounding, the last cell is not lost
  return spans;
}

}  // namespace

OccupancyGrid resample(const OccupancyGrid& grid, double resolution, const std::function<void()>& before_row) {
  if (resolution == grid.resolution()) {
    return grid;
  }
  GridGeometry geometry = grid.geometry();
  geometry.resolution = resolution;
  geometry.validate();
  const double ratio = resolution / grid.resolution();
  geometry.width = newSize(grid.width(), ratio);
  geometry.height = newSize(grid.height(), ratio);

  const std::vector<Span> columns = overlaps(grid.width(), geometry.width, ratio);
  const std::vector<Span> rows = overlaps(grid.height(), geometry.height, ratio);
  OccupancyGrid result(geometry);
  for (int y = 0; y < geometry.height; ++y) {
    if (before_row) {
      before_row();
    }
    for (int old_y = rows[static_cast<std::size_t>(y)].first; old_y < rows[static_cast<std::size_t>(y)].last; ++old_y) {
      for (int x = 0; x < geometry.width; ++x) {
        const Span& span = columns[static_cast<std::size_t>(x)];
        for (int old_x = span.first; old_x < span.last; ++old_x) {
          result.at(x, y) = std::max(result.at(x, y), grid.at(old_x, old_y));
        }
      }
    }
  }
  return result;
}

}  // namespace map_matcher::grid
