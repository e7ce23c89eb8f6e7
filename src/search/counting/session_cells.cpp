#include "map_matcher/search/counting/session_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "shuffling.hpp"

namespace map_matcher::search {
namespace {

struct Box {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
};

Box boundingBox(const std::vector<grid::Cell>& cells) {
  grid::Cell low = cells.front();
  grid::Cell high = cells.front();
  for (const grid::Cell& cell : cells) {
    low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
    high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
  }
  return {{low.x, low.y}, {high.x + 1.0, high.y + 1.0}};
}

using Points = std::vector<Eigen::Vector2d>;

/// Centres of cells [cells of the map].
Points centresOf(const std::vector<grid::Cell>& cells) {
  Points points;
  points.reserve(cells.size());
  for (const grid::Cell& cell : cells) {
    points.emplace_back(cell.x + 0.5, cell.y + 0.5);
  }
  return points;
}

/// Bits of two coordinates in turn, so that numbers near each other are points near each other (Morton order).
std::uint64_t interleavedBits(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint64_t bits) {
    bits = (bits | bits << 16U) & 0x0000FFFF0000FFFFU;
    bits = (bits | bits << 8U) & 0x00FF00FF00FF00FFU;
    bits = (bits | bits << 4U) & 0x0F0F0F0F0F0F0F0FU;
    bits = (bits | bits << 2U) & 0x3333333333333333U;
    return (bits | bits << 1U) & 0x5555555555555555U;
  };
  return spread(x) | spread(y) << 1U;
}

/// A point's place in the Morton order of the cells of `size`, and its index.
struct MortonPlace {
  std::uint64_t bits;
  std::size_t index;

  bool operator<(const MortonPlace& other) const {
    return bits < other.bits || (bits == other.bits && index < other.index);
  }
};

std::vector<MortonPlace> inMortonOrder(const Points& points, double size) {
  constexpr double kOffset = 1 << 24;  // makes every coordinate positive
  std::vector<MortonPlace> places;
  places.reserve(points.size());
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d cell = (p / size).array().floor() + kOffset;
    places.push_back(
        {interleavedBits(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y())), places.size()});
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// One point, their mean, for all points that fall into the same cell of `size`.
Points mergedPoints(const Points& points, double size) {
  const std::vector<MortonPlace> places = inMortonOrder(points, size);
  Points merged;
  for (auto place = places.begin(); place != places.end();) {
    Eigen::Vector2d sum(0.0, 0.0);
    int count = 0;
    for (const std::uint64_t bits = place->bits; place != places.end() && place->bits == bits; ++place) {
      sum += points[place->index];
      ++count;
    }
    merged.push_back(sum / count);
  }
  return merged;
}

/// Neighbouring points beside each other.
Points sorted(const Points& points) {
  Points result;
  result.reserve(points.size());
  for (const MortonPlace& place : inMortonOrder(points, 1.0)) {
    result.push_back(points[place.index]);
  }
  return result;
}

}  // namespace

double farthestPoint(const SessionCells& session) {
  double farthest = 0.0;
  for (const Eigen::Vector2d& p : session.points) {
    farthest = std::max(farthest, p.norm());
  }
  return farthest;
}

int downsamplingSteps(const SessionCells& session) {
  return static_cast<int>(std::floor(std::log2(2.0 * std::max(1, session.longest_side)))) - 1;  // eq. 4.1
}

SessionCells prepareSessionCells(const std::vector<grid::Cell>& cells, double map_resolution, double resolution,
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
  session.points = centresOf(cells);
  if (merging == CellMerging::kMerge) {
    session.points = mergedPoints(session.points, ratio);
  }
  for (Eigen::Vector2d& p : session.points) {
    p = (p - centre) / ratio;
  }
  if (sample_threshold > 0 && session.points.size() > static_cast<std::size_t>(sample_threshold)) {
    shuffle(session.points);
    session.points.resize(static_cast<std::size_t>(sample_threshold));
  }
  session.points = inShuffledNeighbourhoods(sorted(session.points));
  return session;
}

}  // namespace map_matcher::search
