/// \file
/// The best pose that the threads of a search have found so far, and what it lets them prune.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/search/exact/exact_search.hpp"

namespace map_matcher::search {

/// A node of a search: poses first + [0, 2^level)^2 of one rotation, in the exact search of rotation + [0, 2^level).
struct SearchNode {
  std::int32_t bound;  // no pose of the node has more matched cells
  int rotation;
  grid::Cell first;
  int level;
};

/// Whether pose `a` is better than pose `b`.
inline bool better(const SearchPose& a, const SearchPose& b) {
  return std::make_tuple(-a.count, a.rotation, a.translation.y, a.translation.x) <
         std::make_tuple(-b.count, b.rotation, b.translation.y, b.translation.x);
}

/// The poses around a place that was found, which are no place elsewhere.
class ExcludedNeighbourhood {
 public:
  ExcludedNeighbourhood(const SearchPose& place, const ExactProblem& problem)
      : place_(place),
        problem_(problem),
        squared_distance_(problem.distinction.distance * problem.distinction.distance) {}

  /// Whether every pose of the node lies there.
  bool contains(const SearchNode& node) const {
    const int size = (1 << node.level) - 1;
    const double dx =
        std::max(std::abs(node.first.x - place_.translation.x), std::abs(node.first.x + size - place_.translation.x));
    const double dy =
        std::max(std::abs(node.first.y - place_.translation.y), std::abs(node.first.y + size - place_.translation.y));
    if (dx * dx + dy * dy > squared_distance_) {
      return false;
    }
    for (int k = 0; k <= size; ++k) {
      const int steps = node.rotation + k - place_.rotation;
      if (std::abs(grid::normalizeAngle(steps * problem_.rotations.step())) > problem_.distinction.angle) {
        return false;
      }
    }
    return true;
  }

 private:
  SearchPose place_;
  const ExactProblem& problem_;
  double squared_distance_;
};

/// The best pose so far that is not excluded. Thread-safe.
class Incumbent {
 public:
  /// `min_count` is at least 1.
  explicit Incumbent(std::int32_t min_count, std::vector<ExcludedNeighbourhood> excluded = {})
      : threshold_(std::max(1, min_count)), excluded_(std::move(excluded)) {}

  /// Matched cells without which no pose can take its place.
  std::int32_t threshold() const { return threshold_.load(std::memory_order_relaxed); }

  /// Whether no pose of the node can take its place.
  bool prunes(const SearchNode& node) const {
    const std::int32_t threshold = this->threshold();
    return node.bound < threshold || (node.bound == threshold && comesAfterBest(node)) || isExcluded(node);
  }

  /// Takes the pose if it is better. It must not be excluded.
  void offer(const SearchPose& pose) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (pose.count >= threshold_ && (!best_ || better(pose, *best_))) {
      best_ = pose;
      threshold_ = pose.count;
    }
  }

  /// Nothing when none reached the count that was asked for.
  std::optional<SearchPose> best() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return best_;
  }

 private:
  bool isExcluded(const SearchNode& node) const {
    return std::any_of(excluded_.begin(), excluded_.end(),
                       [&node](const ExcludedNeighbourhood& neighbourhood) { return neighbourhood.contains(node); });
  }

  /// Whether the best pose so far, of as many cells as the node's bound, comes before each pose of the node.
  bool comesAfterBest(const SearchNode& node) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return best_ && !better({node.rotation, node.first, node.bound}, *best_);
  }

  mutable std::mutex mutex_;
  std::atomic<std::int32_t> threshold_;  // of the best pose once there is one; that many are needed to be as good
  std::optional<SearchPose> best_;
  std::vector<ExcludedNeighbourhood> excluded_;
};

}  // namespace map_matcher::search
