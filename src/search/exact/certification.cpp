#include "map_matcher/search/exact/certification.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "map_matcher/search/exact/exact_search.hpp"
#include "map_matcher/search/refinement/pose_refiner.hpp"
#include "map_matcher/search/search_frames.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

/// Moves to a better pose nearby, at most, before the exact search begins.
constexpr int kMostClimbs = 20;

/// Rotations looked at on either side of a pose before the exact search.
constexpr int kClimbedRotations = 2;

/// Takes the search for one that was given up before its proof.
void endEarly(SearchResult& result, const work::Deadline& deadline) {
  result.ending = deadline.stopped() ? SearchEnding::kStopped : SearchEnding::kOutOfTime;
  if (deadline.stopped()) {
    result.reason = "the search was stopped before its proof was complete";
  }
}

/// A row of the rotations of a full turn.
struct RotationRange {
  int first = 0;
  int count = 0;
};

class Certification {
 public:
  Certification(const SearchReference& reference, const SearchSession& session, const SearchOptions& options,
                const Demand& demand, const Constraints& constraints, const work::Deadline& deadline)
      : reference_(reference),
        options_(options),
        constraints_(constraints),
        deadline_(deadline),
        frames_(reference.T_reference_grid(), session.T_session_grid),
        cells_(session.fine),
        step_(rotationStep(1.0, cells_.diagonal)),
        range_(allowedRotations()),
        rotations_(cells_, range_.first * step_, step_, range_.count, reference.exact().topLevel(),
                   searchThreads(options), deadline),
        problem_{reference.exact(), rotations_} {
    const int n = rotations_.numCells();
    problem_.windows = priorWindows();
    problem_.min_count = minCount(demand.min_hit_ratio, n);
    problem_.distinction = {options.distinct_distance / cells_.resolution, options.distinct_angle};
    problem_.runner_up_gap = static_cast<int>(std::ceil(demand.margin * n));
  }

  SearchResult run(const SearchResult& answer) {
    result_ = answer;
    result_.total_cells = rotations_.numCells();
    std::optional<SearchPose> start;
    if (answer.found) {
      start = climbFrom(frames_.centrePose(answer.T_reference_session, cells_.centre));
    }
    problem_.known_count = start ? start->count : 0;
    const double preparation_time = watch_.lap();
    const ExactOutcome outcome = exactSearch(problem_, settings());
    report(outcome, preparation_time);
    conclude(outcome, start);
    return result_;
  }

 private:
  /// The rotations that the heading prior allows, all of them without one.
  RotationRange allowedRotations() const {
    const int all = static_cast<int>(std::lround(2.0 * M_PI / step_));
    if (!constraints_.heading || !(constraints_.heading->half_width < M_PI)) {
      return {0, all};
    }
    const double middle = frames_.angleAt(grid::normalizeAngle(constraints_.heading->yaw));
    const double half_width = std::max(0.0, constraints_.heading->half_width);
    const int first = static_cast<int>(std::ceil((middle - half_width) / step_));
    const int last = static_cast<int>(std::floor((middle + half_width) / step_));
    if (last < first) {  // a prior narrower than a step: the rotation nearest to it
      return {static_cast<int>(std::lround(middle / step_)), 1};
    }
    return {first, std::min(last - first + 1, all)};
  }

  std::vector<SearchWindow> priorWindows() const {
    std::vector<SearchWindow> windows;
    for (int n = 0; constraints_.window && n < rotations_.count(); ++n) {
      windows.push_back(frames_.window(constraints_.window, cells_.centre, cells_.resolution, rotations_.angle(n)));
    }
    return windows;
  }

  ExactSettings settings() const {
    ExactSettings settings;
    settings.threads = searchThreads(options_);
    settings.deadline = deadline_;
    return settings;
  }

  /// The best of the poses that lie uphill from one, step by step: a start for the exact search. Nothing when the prior
  /// excludes it.
  std::optional<SearchPose> climbFrom(const CentrePose& pose) const {
    const double all = std::round(2.0 * M_PI / step_);
    const double steps = std::round((pose.angle - rotations_.angle(0)) / step_);
    const Eigen::Vector2d position = pose.position / cells_.resolution;
    SearchPose here;
    here.rotation = static_cast<int>(steps - all * std::floor(steps / all));
    here.translation = {static_cast<int>(std::lround(position.x())), static_cast<int>(std::lround(position.y()))};
    std::optional<SearchPose> best;
    for (int climb = 0; climb < kMostClimbs && !deadline_.passed(); ++climb) {
      const SearchPose next = bestAround(best ? *best : here);
      if (next.count <= (best ? best->count : 0)) {
        break;
      }
      best = next;
    }
    return best;
  }

  /// The best allowed pose around one; its count is 0 when none is allowed.
  SearchPose bestAround(const SearchPose& middle) const {
    const grid::Cell first{middle.translation.x - kTileColumns / 2, middle.translation.y - kTileRows / 2};
    const ScoreKernel kernel;
    std::vector<TileScore> scores;
    SearchPose best;
    for (int turn = -kClimbedRotations; turn <= kClimbedRotations; ++turn) {
      const int n = middle.rotation + turn;
      if (n < 0 || n >= rotations_.count()) {
        continue;
      }
      const RotatedCells rotated = rotate(cells_, rotations_.angle(n));
      kernel.scoreTile(reference_.exact().level(0), rotated, reference_.exact().position(0, first), {}, best.count + 1,
                       scores);
      const SearchWindow window =
          problem_.windows.empty() ? everywhere() : problem_.windows[static_cast<std::size_t>(n)];
      for (const TileScore& score : scores) {
        const grid::Cell t{first.x + score.column, first.y + score.row};
        const bool allowed =
            t.x >= window.first.x && t.x <= window.last.x && t.y >= window.first.y && t.y <= window.last.y;
        if (allowed && score.count > best.count) {
          best = {n, t, score.count};
        }
      }
    }
    return best;
  }

  void report(const ExactOutcome& outcome, double preparation_time) {
    StageReport stage;
    stage.name = "exact";
    stage.answered = outcome.best_proven && outcome.best;
    stage.resolution = cells_.resolution;
    stage.rotations = rotations_.count();
    stage.rotation_step = step_;
    stage.total_cells = rotations_.numCells();
    stage.matched_cells = outcome.best ? outcome.best->count : 0;
    stage.ratio = ratio(stage.matched_cells);
    stage.nodes_scored = outcome.nodes_scored;
    stage.nodes_expanded = outcome.nodes_expanded;
    stage.initialization_time = preparation_time;
    stage.rotation_expansion_time = outcome.root_time;
    stage.depth_first_search_time = outcome.below_time;
    result_.stages.push_back(stage);
  }

  void conclude(const ExactOutcome& outcome, const std::optional<SearchPose>& start) {
    result_.certified = outcome.best_proven;
    result_.runner_up_proven = outcome.runner_up_proven;
    result_.upper_bound = ratio(outcome.upper_bound);
    const std::optional<SearchPose>& best = outcome.best ? outcome.best : start;
    result_.found = best.has_value();
    if (best) {
      result_.replaced = !start || elsewhere(*start, *best);
      place(*best);
      result_.margin =
          outcome.best && outcome.best_proven ? ratio(std::max(0, best->count - outcome.runner_up_bound)) : 0.0;
    }
    if (outcome.runner_up) {
      result_.runner_up = RunnerUp{mapPose(*outcome.runner_up), ratio(outcome.runner_up->count)};
    }
    if (!outcome.best_proven || !outcome.runner_up_proven) {
      endEarly(result_, deadline_);
    }
    if (best && outcome.best_proven) {
      refinePose(*best);
    }
  }

  /// Takes a pose as the answer.
  void place(const SearchPose& pose) {
    result_.T_reference_session = mapPose(pose);
    result_.refined = true;
    result_.hit_cells = pose.count;
    result_.hit_ratio = ratio(pose.count);
    countMatches(centrePose(pose));
  }

  /// The strict count at a pose, of session cells whose centres fall into walls.
  void countMatches(const CentrePose& pose) {
    const PooledLevel& walls = reference_.fine().level(0);
    const grid::Rigid2 T{pose.position.x() / cells_.resolution, pose.position.y() / cells_.resolution, pose.angle};
    const Eigen::Matrix2d R = T.rotation();
    result_.matched_cells = 0;
    for (const Eigen::Vector2d& p : cells_.points) {
      const Eigen::Vector2d cell = (R * p + T.translation()).array().floor();
      result_.matched_cells += walls.at(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
    }
    result_.ratio = ratio(result_.matched_cells);
  }

  /// Moves the answer from whole cells to where the session lies best (the maps' walls as they are, not the wider
  /// hits).
  void refinePose(const SearchPose& pose) {
    result_.searched = mapPose(pose);
    const RefinedPose refined = refine(reference_.walls(), cells_, centrePose(pose), options_.hit_tolerance);
    result_.T_reference_session = frames_.mapPose(refined.pose, cells_.centre);
    result_.covariance = frames_.mapCovariance(refined.covariance, refined.pose.angle, cells_.centre);
    countMatches(refined.pose);
  }

  bool elsewhere(const SearchPose& a, const SearchPose& b) const {
    const double distance = std::hypot(a.translation.x - b.translation.x, a.translation.y - b.translation.y);
    const double turn = std::abs(grid::normalizeAngle((a.rotation - b.rotation) * step_));
    return distance > problem_.distinction.distance || turn > problem_.distinction.angle;
  }

  CentrePose centrePose(const SearchPose& pose) const {
    const Eigen::Vector2d cells(pose.translation.x, pose.translation.y);
    return {rotations_.angle(pose.rotation), cells * cells_.resolution};
  }

  grid::Rigid2 mapPose(const SearchPose& pose) const { return frames_.mapPose(centrePose(pose), cells_.centre); }

  double ratio(int count) const { return static_cast<double>(count) / rotations_.numCells(); }

  work::Stopwatch watch_;
  const SearchReference& reference_;
  const SearchOptions& options_;
  const Constraints& constraints_;
  const work::Deadline& deadline_;
  SearchFrames frames_;
  const SessionCells& cells_;
  double step_;
  RotationRange range_;
  RotationBlocks rotations_;
  ExactProblem problem_;
  SearchResult result_;
};

}  // namespace

SearchResult certify(const SearchResult& answer, const SearchReference& reference, const SearchSession& session,
                     const SearchOptions& options, const Demand& demand, const Constraints& constraints,
                     const work::Deadline& deadline) {
  SearchResult result = answer;
  result.exact = true;
  if (!answer.ended()) {
    return result;
  }
  result.ending = SearchEnding::kSearched;
  result.session_centre = session.T_session_grid * session.fine.centre;
  try {
    deadline.throwIfPassed();
    return Certification(reference, session, options, demand, constraints, deadline).run(result);
  } catch (const work::DeadlinePassed&) {
    endEarly(result, deadline);
    return result;
  }
}

}  // namespace map_matcher::search
