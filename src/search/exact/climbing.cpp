#include "climbing.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "incumbent.hpp"

namespace map_matcher::search {
namespace {

/// Moves to a better pose nearby, at most.
constexpr int kMostClimbs = 20;

/// Rotations looked at on either side of a pose.
constexpr int kClimbedRotations = 2;

/// Rows of tiles looked at around a pose: a tile is wide, but not high.
constexpr int kClimbedTiles = 3;

class Climb {
 public:
  Climb(const ExactProblem& problem, const work::Deadline& deadline)
      : problem_(problem),
        deadline_(deadline),
        full_turn_(static_cast<int>(std::lround(2.0 * M_PI / problem.rotations.step()))) {}

  std::optional<SearchPose> run(const CentrePose& pose, double resolution) {
    const double turn = std::remainder(pose.angle - problem_.rotations.angle(0), 2.0 * M_PI);
    const Eigen::Vector2d position =
        (pose.position / resolution).cwiseMax(everywhere().first.x).cwiseMin(everywhere().last.x);
    if (!(std::isfinite(turn) && position.allFinite())) {
      return std::nullopt;
    }
    SearchPose here;
    here.rotation = inFullTurn(static_cast<int>(std::lround(turn / problem_.rotations.step())));
    here.translation = {static_cast<int>(std::lround(position.x())), static_cast<int>(std::lround(position.y()))};
    std::optional<SearchPose> best;
    for (int climb = 0; climb < kMostClimbs && !deadline_.passed(); ++climb) {
      const SearchPose next = bestAround(best ? *best : here);
      if (next.count == 0 || (best && !better(next, *best))) {
        break;
      }
      best = next;
    }
    return best;
  }

 private:
  /// The best allowed pose around one; its count is 0 when none that is allowed has a hit.
  SearchPose bestAround(const SearchPose& middle) {
    SearchPose best;
    for (int turn = -kClimbedRotations; turn <= kClimbedRotations; ++turn) {
      const int n = inFullTurn(middle.rotation + turn);
      if (n >= problem_.rotations.count()) {
        continue;
      }
      const WeightedCells cells = problem_.rotations.cells(BlockShape{0}, n);
      for (int tile = 0; tile < kClimbedTiles; ++tile) {
        const grid::Cell first{middle.translation.x - kTileColumns / 2,
                               middle.translation.y - kTileRows * kClimbedTiles / 2 + kTileRows * tile};
        best = bestOfTile(n, cells, first, best);
      }
    }
    return best;
  }

  /// The best allowed pose of a tile, or `best` when none is better.
  SearchPose bestOfTile(int rotation, const WeightedCells& cells, const grid::Cell& first, SearchPose best) {
    kernel_.scoreTile(problem_.reference.level(0), cells, problem_.reference.position(0, first), {},
                      std::max(1, best.count), scores_);
    const SearchWindow window =
        problem_.windows.empty() ? everywhere() : problem_.windows[static_cast<std::size_t>(rotation)];
    for (const TileScore& score : scores_) {
      const grid::Cell t{first.x + score.column, first.y + score.row};
      const SearchPose pose{rotation, t, score.count};
      const bool allowed =
          t.x >= window.first.x && t.x <= window.last.x && t.y >= window.first.y && t.y <= window.last.y;
      if (allowed && (best.count == 0 || better(pose, best))) {
        best = pose;
      }
    }
    return best;
  }

  /// The same rotation within the turn that begins with the first one.
  int inFullTurn(int rotation) const { return (rotation % full_turn_ + full_turn_) % full_turn_; }

  const ExactProblem& problem_;
  const work::Deadline& deadline_;
  int full_turn_;  // [rotations]
  ScoreKernel kernel_;
  std::vector<TileScore> scores_;  // of the last tile
};

}  // namespace

std::optional<SearchPose> climbFrom(const CentrePose& pose, double resolution, const ExactProblem& problem,
                                    const work::Deadline& deadline) {
  return Climb(problem, deadline).run(pose, resolution);
}

}  // namespace map_matcher::search
