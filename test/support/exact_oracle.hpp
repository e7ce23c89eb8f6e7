/// \file
/// The slow and obvious exact search: tries every pose.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <tuple>
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

/// The best pose and the best one elsewhere.
struct BestPoses {
  std::optional<search::SearchPose> best;
  std::optional<search::SearchPose> runner_up;
};

inline bool firstOfEqual(const search::SearchPose& a, const search::SearchPose& b) {
  return std::make_tuple(-a.count, a.rotation, a.translation.y, a.translation.x) <
         std::make_tuple(-b.count, b.rotation, b.translation.y, b.translation.x);
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
        poses.push_back({n, {x, y}, hits.count(cells, {x, y})});
      }
    }
  }
  BestPoses result;
  for (const search::SearchPose& pose : poses) {
    if (pose.count >= std::max(1, problem.min_count) && (!result.best || firstOfEqual(pose, *result.best))) {
      result.best = pose;
    }
  }
  for (const search::SearchPose& pose : poses) {
    if (!result.best) {
      break;
    }
    const search::SearchPose& best = *result.best;
    const double distance =
        std::hypot(pose.translation.x - best.translation.x, pose.translation.y - best.translation.y);
    const double turn = std::abs(grid::normalizeAngle((pose.rotation - best.rotation) * problem.rotations.step()));
    const bool elsewhere = distance > problem.distinction.distance || turn > problem.distinction.angle;
    const bool enough = pose.count >= std::max(1, best.count - problem.runner_up_gap);
    if (elsewhere && enough && (!result.runner_up || firstOfEqual(pose, *result.runner_up))) {
      result.runner_up = pose;
    }
  }
  return result;
}

}  // namespace map_matcher::test
