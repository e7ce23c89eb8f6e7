#include "map_matcher/search/session_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <utility>

namespace map_matcher {
namespace {

/// Points of a neighbourhood.
constexpr std::size_t kNeighbourhood = 64;

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

using Points = std::vector<Eigen::Vector2d>;

/// Centres of cells [cells of the map].
Points centresOf(const std::vector<Cell>& cells) {
  Points points;
  points.reserve(cells.size());
  for (const Cell& cell : cells) {
    points.emplace_back(cell.x + 0.5, cell.y + 0.5);
  }
  return points;
}

/// One point, their mean, for all cells that fall into the same cell of `ratio` times the size.
Points mergedCentres(const std::vector<Cell>& cells, double ratio) {
  struct Sum {
    Eigen::Vector2d points{0.0, 0.0};
    int count = 0;
  };
  std::map<std::pair<int, int>, Sum> larger_cells;
  for (const Eigen::Vector2d& p : centresOf(cells)) {
    const Eigen::Vector2d larger = (p / ratio).array().floor();
    Sum& sum = larger_cells[{static_cast<int>(larger.y()), static_cast<int>(larger.x())}];
    sum.points += p;
    ++sum.count;
  }
  Points points;
  for (const auto& [cell, sum] : larger_cells) {
    points.push_back(sum.points / sum.count);
  }
  return points;
}

/// Fisher-Yates with a fixed seed. std::shuffle may differ between standard libraries.
template <typename T>
void shuffle(std::vector<T>& values) {
  std::mt19937 random;  // its default seed
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[random() % i]);
  }
}

/// Bits of two coordinates in turn, so that numbers near each other are points near each other (Morton order).
std::uint64_t interleavedBits(const Eigen::Vector2d& point) {
  constexpr double kOffset = 1 << 24;  // makes every coordinate positive
  std::uint64_t bits = 0;
  const auto x = static_cast<std::uint64_t>(std::floor(point.x()) + kOffset);
  const auto y = static_cast<std::uint64_t>(std::floor(point.y()) + kOffset);
  for (unsigned bit = 0; bit < 26; ++bit) {
    bits |= ((x >> bit & 1U) << (2 * bit)) | ((y >> bit & 1U) << (2 * bit + 1));
  }
  return bits;
}

/// Neighbouring points beside each other, for the processor's caches, but the neighbourhoods in shuffled order, so that
/// a search knows early what a pose is worth.
Points inShuffledNeighbourhoods(const Points& points) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    order.emplace_back(interleavedBits(points[k]), k);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> neighbourhoods((points.size() + kNeighbourhood - 1) / kNeighbourhood);
  std::iota(neighbourhoods.begin(), neighbourhoods.end(), std::size_t{0});
  shuffle(neighbourhoods);
  Points result;
  for (const std::size_t neighbourhood : neighbourhoods) {
    const std::size_t begin = neighbourhood * kNeighbourhood;
    for (std::size_t k = begin; k < std::min(begin + kNeighbourhood, points.size()); ++k) {
      result.push_back(points[order[k].second]);
    }
  }
  return result;
}

}  // namespace

int downsamplingSteps(const SessionCells& session) {
  return static_cast<int>(std::floor(std::log2(2.0 * std::max(1, session.longest_side)))) - 1;  // eq. 4.1
}

SessionCells prepareSessionCells(const std::vector<Cell>& cells, double map_resolution, double resolution,
                                 CellMerging merging, int sample_threshold) {
  const double ratio = resolution / map_resolution;

  const Box box = boundingBox(cells);
  const Eigen::Vector2d centre = 0.5 * (box.low + box.high);
  const Eigen::Vector2d size = (box.high - box.low) / ratio;

  SessionCells session;
  session.resolution = resolution;
  session.centre = centre * map_resolution;
  session.diagonal = size.norm();
  session.longest_side = static_cast<int>(std::ceil(size.maxCoeff()));
  session.points = merging == CellMerging::kMerge ? mergedCentres(cells, ratio) : centresOf(cells);
  for (Eigen::Vector2d& p : session.points) {
    p = (p - centre) / ratio;
  }
  if (sample_threshold > 0 && session.points.size() > static_cast<std::size_t>(sample_threshold)) {
    shuffle(session.points);
    session.points.resize(static_cast<std::size_t>(sample_threshold));
  }
  session.points = inShuffledNeighbourhoods(session.points);
  return session;
}

}  // namespace map_matcher
