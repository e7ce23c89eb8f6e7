#include "map_matcher/search/exact/rotation_blocks.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "../counting/vector_clones.hpp"
#include "map_matcher/work/parallel.hpp"

namespace map_matcher::search {
namespace {

/// Turning by an angle and moving by `offset` along both axes, in steps of the grain.
struct Turn {
  float cosine;
  float sine;
  float offset;
};

/// floor() of the turned points. Truncating and correcting is what compilers turn into vector instructions everywhere.
MAP_MATCHER_VECTOR_CLONES
void turnToCells(const float* x, const float* y, std::size_t size, const Turn& turn, std::int16_t* cell_x,
                 std::int16_t* cell_y) {
  for (std::size_t k = 0; k < size; ++k) {
    const float turned_x = turn.cosine * x[k] - turn.sine * y[k] + turn.offset;
    const float turned_y = turn.sine * x[k] + turn.cosine * y[k] + turn.offset;
    const int whole_x = static_cast<int>(turned_x);
    const int whole_y = static_cast<int>(turned_y);
    cell_x[k] = static_cast<std::int16_t>(whole_x - (static_cast<float>(whole_x) > turned_x ? 1 : 0));
    cell_y[k] = static_cast<std::int16_t>(whole_y - (static_cast<float>(whole_y) > turned_y ? 1 : 0));
  }
}

}  // namespace

RotationBlocks::RotationBlocks(const SessionCells& session, double first_angle, double step, int count, int top_level,
                               int threads, const work::Deadline& deadline)
    : session_(session), first_angle_(first_angle), step_(step), count_(count) {
  const double farthest = farthestPoint(session);
  if (!(step > 0.0 && step * farthest <= 0.5)) {
    throw std::invalid_argument("a rotation step of " + std::to_string(step) + " rad moves a session cell by " +
                                std::to_string(step * farthest) + " cells, expected at most 0.5");
  }
  clusters_.resize(static_cast<std::size_t>(top_level));
  work::parallelFor(threads, clusters_.size(), [&](std::size_t n) {
    clusters_[n] = clustersOf(session, BlockShape{static_cast<int>(n) + 1}, deadline);
  });
}

WeightedCells RotationBlocks::cells(const BlockShape& shape, int first_rotation) const {
  if (shape.level == 0) {
    return {rotate(session_, angle(first_rotation)), {{session_.points.size(), 1}}, numCells()};
  }
  const SessionClusters& clusters = clusters_[static_cast<std::size_t>(shape.level - 1)];
  const double middle = angle(first_rotation) + 0.5 * (shape.stride() - 1) * step_;
  const double step = 1.0 / shape.grain();
  const Turn turn{static_cast<float>(step * std::cos(middle)), static_cast<float>(step * std::sin(middle)),
                  static_cast<float>(-0.5 * step * shape.room())};
  const std::size_t size = clusters.x.size();
  WeightedCells cells{
      {std::vector<std::int16_t>(size), std::vector<std::int16_t>(size)}, clusters.runs, clusters.total};
  turnToCells(clusters.x.data(), clusters.y.data(), size, turn, cells.cells.x.data(), cells.cells.y.data());
  return cells;
}

}  // namespace map_matcher::search
