#include "map_matcher/search/counting/session_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>

#include "shuffling.hpp"

namespace map_matcher::search {
namespace {

/// Half of what is left free of a window for the rounding of single precision, which is below 0.01 cells for
/// kMaxSessionDiagonal [cells].
constexpr double kRounding = 0.02;

/// Clusters of a size from which on they are counted once, and their number multiplied, rather than digit by digit.
constexpr std::size_t kManyAlike = 24;

/// Sets of more points are divided with a look at the deadline.
constexpr std::ptrdiff_t kLookedAfter = 256;

struct Cluster {
  Eigen::Vector2d middle;
  std::int32_t size;
};

/// Halves sets of points until each fits into a window.
class Clustering {
 public:
  Clustering(const SessionCells& session, const BlockShape& shape, const work::Deadline& deadline)
      : deadline_(deadline),
        points_(session.points),
        arc_(shape.halfArc() / std::max(farthestPoint(session), 1e-9)),
        room_(0.5 * shape.room() - kRounding) {}

  std::vector<Cluster> run() {
    divide(points_.begin(), points_.end());
    return clusters_;
  }

 private:
  using Point = std::vector<Eigen::Vector2d>::iterator;

  void divide(Point begin, Point end) {
    if (end - begin > kLookedAfter) {
      deadline_.throwIfPassed();
    }
    Eigen::Vector2d low = *begin;
    Eigen::Vector2d high = *begin;
    for (Point p = begin; p != end; ++p) {
      low = low.cwiseMin(*p);
      high = high.cwiseMax(*p);
    }
    const Eigen::Vector2d middle = 0.5 * (low + high);
    const auto size = end - begin;
    if (size == 1 || fits(begin, end, middle)) {
      clusters_.push_back({middle, static_cast<std::int32_t>(size)});
      return;
    }
    const int axis = high.x() - low.x() > high.y() - low.y() ? 0 : 1;
    const Point half = std::partition(begin, end, [&](const Eigen::Vector2d& p) { return p[axis] < middle[axis]; });
    if (half == begin || half == end) {  // all points in one spot
      clusters_.push_back({middle, static_cast<std::int32_t>(size)});
      return;
    }
    divide(begin, half);
    divide(half, end);
  }

  /// The middle turns by at most the node's arc, and the points stay as far from it as they are.
  bool fits(Point begin, Point end, const Eigen::Vector2d& middle) const {
    const double radius = room_ - arc_ * middle.norm();
    return radius > 0.0 && std::all_of(begin, end, [&](const Eigen::Vector2d& p) {
             return (p - middle).squaredNorm() <= radius * radius;
           });
  }

  const work::Deadline& deadline_;
  std::vector<Eigen::Vector2d> points_;
  double arc_;   // that a cell at unit distance describes, to either side
  double room_;  // to either side
  std::vector<Cluster> clusters_;
};

}  // namespace

SessionClusters clustersOf(const SessionCells& session, const BlockShape& shape, const work::Deadline& deadline) {
  SessionClusters result;
  if (session.points.empty()) {
    return result;
  }
  const std::vector<Cluster> clusters = inShuffledNeighbourhoods(Clustering(session, shape, deadline).run());
  std::map<std::int32_t, std::vector<const Cluster*>, std::greater<>> of_size;
  for (const Cluster& cluster : clusters) {
    of_size[cluster.size].push_back(&cluster);
    result.total += cluster.size;
  }
  std::map<std::int32_t, std::vector<const Cluster*>, std::greater<>> runs;
  for (const auto& [size, alike] : of_size) {
    const bool many = alike.size() >= kManyAlike;
    for (std::int32_t weight = many ? size : 1; weight <= size; weight *= 2) {
      if (many || (size & weight) != 0) {
        std::vector<const Cluster*>& run = runs[weight];
        run.insert(run.end(), alike.begin(), alike.end());
      }
    }
  }
  for (const auto& [weight, members] : runs) {
    for (const Cluster* cluster : members) {
      result.x.push_back(static_cast<float>(cluster->middle.x()));
      result.y.push_back(static_cast<float>(cluster->middle.y()));
    }
    result.runs.push_back({members.size(), weight});
  }
  return result;
}

}  // namespace map_matcher::search
