/// \file
/// The slow and obvious exact search: tries every pose.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/search/exact/exact_search.hpp"

namespace map_matcher::test {

/// Which cells of a map, and of a border around it, lie within a tolerance of a wall.
class HitMap {
 public:
  HitMap(int width, int height, const std::vector<grid::Cell>& walls, double tolerance)
      : border_(static_cast<int>(std::ceil(tolerance)) + 1),
        width_(width + 2 * border_),
        height_(height + 2 * border_) {
    for (int y = -border_; y < height + border_; ++y) {
      for (int x = -border_; x < width + border_; ++x) {
        bool hit = false;
        for (const grid::Cell& wall : walls) {
          hit = hit || std::hypot(wall.x - x, wall.y - y) <= tolerance + 1e-6;
        }
        hits_.push_back(hit);
      }
    }
  }

  bool at(int x, int y) const {
    const int column = x + border_;
    const int row = y + border_;
    return column >= 0 && row >= 0 && column < width_ && row < height_ &&
           hits_[static_cast<std::size_t>(row * width_ + column)];
  }

  std::int32_t count(const search::RotatedCells& cells, const grid::Cell& translation) const {
    std::int32_t count = 0;
    for (std::size_t k = 0; k < cells.x.size(); ++k) {
      count += at(cells.x[k] + translation.x, cells.y[k] + translation.y) ? 1 : 0;
    }
    return count;
  }

 private:
  int border_;
  int width_;
  int height_;
  std::vector<bool> hits_;
};

/// The best pose and the best one elsewhere, and all places that a greedy search takes one after the other.
struct BestPoses {
  std::optional<search::SearchPose> best;
  std::optional<search::SearchPose> runner_up;
  std::vector<search::SearchPose> poses;  ///< All that have a hit, the best first.
};

inline bool firstOfEqual(const search::SearchPose& a, const search::SearchPose& b) {
  return std::make_tuple(-a.count, a.rotation, a.translation.y, a.translation.x) <
         std::make_tuple(-b.count, b.rotation, b.translation.y, b.translation.x);
}

/// Whether a pose is another place than one that was found.
inline bool distinct(const search::ExactProblem& problem, const search::SearchPose& pose,
                     const search::SearchPose& place) {
  const double distance =
      std::hypot(pose.translation.x - place.translation.x, pose.translation.y - place.translation.y);
  const double turn = std::abs(grid::normalizeAngle((pose.rotation - place.rotation) * problem.rotations.step()));
  return distance > problem.distinction.distance || turn > problem.distinction.angle;
}

/// The best of all poses, the best first, that is distinct from all places, if it has as many hits.
inline std::optional<search::SearchPose> bestElsewhere(const search::ExactProblem& problem,
                                                       const std::vector<search::SearchPose>& poses,
                                                       const std::vector<search::SearchPose>& places, int min_count) {
  const auto best = std::find_if(poses.begin(), poses.end(), [&](const search::SearchPose& pose) {
    return std::all_of(places.begin(), places.end(),
                       [&](const search::SearchPose& place) { return distinct(problem, pose, place); });
  });
  return best != poses.end() && best->count >= std::max(1, min_count) ? std::make_optional(*best) : std::nullopt;
}

/// Tries all poses of the problem; without windows, all translations of up to `reach` cells.
inline BestPoses tryAllPoses(const search::ExactProblem& problem, const search::SessionCells& session,
                             const HitMap& hits, int reach) {
  std::vector<search::SearchPose> poses;
  for (int n = 0; n < problem.rotations.count(); ++n) {
    const search::RotatedCells cells = search::rotate(session, problem.rotations.angle(n));
    const search::SearchWindow window = problem.windows.empty() ? search::SearchWindow{{-reach, -reach}, {reach, reach}}
                                                                : problem.windows[static_cast<std::size_t>(n)];
    for (int y = window.first.y; y <= window.last.y; ++y) {
      for (int x = window.first.x; x <= window.last.x; ++x) {
        const std::int32_t count = hits.count(cells, {x, y});
        if (count > 0) {
          poses.push_back({n, {x, y}, count});
        }
      }
    }
  }
  std::sort(poses.begin(), poses.end(), firstOfEqual);
  BestPoses result;
  result.best = bestElsewhere(problem, poses, {}, problem.min_count);
  if (result.best) {
    result.runner_up = bestElsewhere(problem, poses, {*result.best}, result.best->count - problem.runner_up_gap);
  }
  result.poses = std::move(poses);
  return result;
}

/// The places that are found one after the other, greedily: each the best pose that is distinct from those before it,
/// as long as it reaches what is still of interest.
inline std::vector<search::SearchPose> greedyPlaces(const search::ExactProblem& problem, const BestPoses& truth) {
  std::vector<search::SearchPose> places;
  double largest_worth = 0.0;
  const auto take = [&](int min_count) {
    const std::optional<search::SearchPose> place = bestElsewhere(problem, truth.poses, places, min_count);
    if (place) {
      places.push_back(*place);
      largest_worth = std::max(largest_worth, problem.worth ? problem.worth(*place) : place->count);
    }
    return place.has_value();
  };
  bool found = take(problem.min_count);
  if (found && problem.most_places > 1) {
    take(places.front().count - problem.runner_up_gap);
  }
  while (found && static_cast<int>(places.size()) < problem.most_places) {
    const auto least = static_cast<int>(std::floor(largest_worth + 1e-6)) - problem.runner_up_gap;
    found = take(std::max(problem.min_count, least));
  }
  return places;
}

}  // namespace map_matcher::test
