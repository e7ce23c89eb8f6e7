#include "map_matcher/search/exact/certification.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "../placing.hpp"
#include "climbing.hpp"
#include "incumbent.hpp"
#include "map_matcher/search/exact/exact_search.hpp"
#include "map_matcher/search/search_frames.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

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
      : options_(options),
        constraints_(constraints),
        deadline_(deadline),
        frames_(reference.T_reference_grid(), session.T_session_grid),
        cells_(session.fine),
        step_(rotationStep(1.0, cells_.diagonal)),
        range_(allowedRotations()),
        rotations_(cells_, range_.first * step_, step_, range_.count, reference.exact().topLevel(),
                   searchThreads(options), deadline),
        placing_(reference, session, options, rotations_),
        demand_(demand),
        problem_{reference.exact(), rotations_} {
    const int n = rotations_.numCells();
    problem_.windows = priorWindows();
    problem_.min_count = minCount(demand.min_hit_ratio, n);
    problem_.distinction = {options.distinct_distance / cells_.resolution, options.distinct_angle};
    problem_.runner_up_gap = static_cast<int>(std::ceil(demand.margin * n));
    problem_.most_places = demand.most_places;
    problem_.worth = [this, n](const SearchPose& pose) { return addPlace(pose) * n; };
  }

  SearchResult run(const SearchResult& answer) {
    result_ = answer;
    result_.total_cells = rotations_.numCells();
    const std::optional<SearchPose> start = bestStart(answer);
    if (start) {
      problem_.known_count = start->count;
    }
    if (start && start->count >= problem_.min_count) {
      start_ = *start;
      start_place_ = judged(*start);
      problem_.known_worth = start_place_->worth * rotations_.numCells();
    }
    const double preparation_time = watch_.lap();
    const ExactOutcome outcome = exactSearch(problem_, settings());
    report(outcome, preparation_time);
    conclude(outcome, start);
    return result_;
  }

 private:
  /// The pose with most hits near the two stages' answer, if they have one, or near one of the caller's places.
  std::optional<SearchPose> bestStart(const SearchResult& answer) const {
    std::vector<grid::Rigid2> places = demand_.starts;
    if (answer.found) {
      places.push_back(answer.T_reference_session);
    }
    std::optional<SearchPose> best;
    for (const grid::Rigid2& T_reference_session : places) {
      const std::optional<SearchPose> pose =
          climbFrom(frames_.centrePose(T_reference_session, cells_.centre), cells_.resolution, problem_, deadline_);
      if (pose && (!best || better(*pose, *best))) {
        best = pose;
      }
    }
    return best;
  }

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

  void report(const ExactOutcome& outcome, double preparation_time) {
    StageReport stage;
    stage.name = "exact";
    stage.answered = outcome.best_proven && outcome.best;
    stage.resolution = cells_.resolution;
    stage.rotations = rotations_.count();
    stage.rotation_step = step_;
    stage.total_cells = rotations_.numCells();
    stage.matched_cells = outcome.best ? outcome.best->count : 0;
    stage.ratio = placing_.ratio(stage.matched_cells);
    stage.nodes_scored = outcome.nodes_scored;
    stage.nodes_expanded = outcome.nodes_expanded;
    stage.initialization_time = preparation_time;
    stage.rotation_expansion_time = outcome.root_time;
    stage.depth_first_search_time = outcome.below_time;
    result_.stages.push_back(stage);
  }

  /// Adds a place that was found to the result; what it is worth.
  double addPlace(const SearchPose& pose) {
    const bool is_start = start_place_ && pose.rotation == start_.rotation && pose.translation == start_.translation;
    result_.places.push_back(is_start ? *start_place_ : judged(pose));
    return result_.places.back().worth;
  }

  Place judged(const SearchPose& pose) const {
    Place place = placing_.placeOf(pose);
    if (demand_.worth) {
      place.worth = demand_.worth(place);
    }
    return place;
  }

  void conclude(const ExactOutcome& outcome, const std::optional<SearchPose>& start) {
    result_.certified = outcome.best_proven;
    result_.runner_up_proven = outcome.runner_up_proven;
    result_.upper_bound = placing_.ratio(outcome.upper_bound);
    result_.elsewhere_bound = placing_.ratio(outcome.elsewhere_bound);
    const std::optional<SearchPose>& best = outcome.best ? outcome.best : start;
    result_.found = best.has_value();
    if (best && best->count >= problem_.min_count && result_.places.empty()) {
      addPlace(*best);  // the search was cut before it found any as good
    }
    if (best) {
      result_.replaced = !start || elsewhere(*start, *best);
      place(*best, outcome.best_proven);
      result_.margin = outcome.best && outcome.best_proven
                           ? placing_.ratio(std::max(0, best->count - outcome.runner_up_bound))
                           : 0.0;
    }
    if (outcome.runner_up) {
      result_.runner_up = RunnerUp{placing_.mapPose(*outcome.runner_up), placing_.ratio(outcome.runner_up->count)};
    }
    if (!outcome.complete) {
      endEarly(result_, deadline_);
    }
  }

  /// Takes a pose as the answer; one that is proven is moved from whole cells to where the session lies best.
  void place(const SearchPose& pose, bool proven) {
    if (proven) {
      setAnswer(result_, result_.places.empty() ? placing_.placeOf(pose) : result_.places.front());
      return;
    }
    result_.refined = true;
    result_.hit_cells = pose.count;
    result_.hit_ratio = placing_.ratio(pose.count);
    result_.T_reference_session = placing_.mapPose(pose);
    result_.matched_cells = placing_.matchesAt(placing_.centrePose(pose));
    result_.ratio = placing_.ratio(result_.matched_cells);
  }

  bool elsewhere(const SearchPose& a, const SearchPose& b) const {
    const double distance = std::hypot(a.translation.x - b.translation.x, a.translation.y - b.translation.y);
    const double turn = std::abs(grid::normalizeAngle((a.rotation - b.rotation) * step_));
    return distance > problem_.distinction.distance || turn > problem_.distinction.angle;
  }

  work::Stopwatch watch_;
  const SearchOptions& options_;
  const Constraints& constraints_;
  const work::Deadline& deadline_;
  SearchFrames frames_;
  const SessionCells& cells_;
  double step_;
  RotationRange range_;
  RotationBlocks rotations_;
  Placing placing_;
  const Demand& demand_;
  ExactProblem problem_;
  SearchPose start_;  // that the search begins with
  std::optional<Place> start_place_;
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
