#include "map_matcher/search/two_stage/two_stage_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include "../input_check.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/counting/session_cells.hpp"
#include "map_matcher/search/search_frames.hpp"
#include "map_matcher/search/two_stage/branch_and_bound.hpp"
#include "map_matcher/search/two_stage/rotation_bands.hpp"
#include "map_matcher/search/two_stage/scouting.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

/// Fine searches around an answer on the edge of the window before it, after which the last answer stands.
constexpr int kMaxFineSearches = 4;

/// Session cells by which the bands of the coarse stage are put in order.
constexpr int kScoutCells = 128;

/// One stage with all that it reads and writes.
struct Stage {
  Stage(const char* name, const PrecomputedGrids& reference) : problem{reference, {}, {}, {}, 1, 0} {
    report.name = name;
    problem.cells = [this](int n) { return rotate(session, angles[static_cast<std::size_t>(n)]); };
    problem.turned = [this](double angle) { return rotate(session, angle); };
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  SessionCells session;
  std::vector<double> angles;  // of each rotation [rad]
  SearchProblem problem;
  SearchOutcome outcome;
  StageReport report;
};

/// Adds the outcome of a search to the stage's report.
void record(Stage& stage, SearchOutcome outcome) {
  StageReport& report = stage.report;
  report.answered = outcome.best.has_value() && !outcome.stopped;
  report.resolution = stage.session.resolution;
  report.rotations = static_cast<int>(stage.angles.size());
  report.total_cells = static_cast<int>(stage.session.points.size());
  report.matched_cells = outcome.best ? outcome.best->count : 0;
  report.ratio = static_cast<double>(report.matched_cells) / report.total_cells;
  report.nodes_scored += outcome.nodes_scored;
  report.nodes_expanded += outcome.nodes_expanded;
  report.rotation_expansion_time += outcome.rotation_expansion_time;
  report.depth_first_search_time += outcome.depth_first_search_time;
  stage.outcome = std::move(outcome);
}

CentrePose poseOf(const Stage& stage) {
  const SearchPose& best = *stage.outcome.best;
  const Eigen::Vector2d cells(best.translation.x, best.translation.y);
  return {stage.angles[static_cast<std::size_t>(best.rotation)], cells * stage.session.resolution};
}

/// The search of one session map in one reference map.
class TwoStageSearch {
 public:
  TwoStageSearch(const SearchReference& reference, const SearchSession& session, const SearchOptions& options,
                 const Constraints& constraints, const work::Deadline& deadline,
                 std::optional<std::int64_t> most_expansions)
      : reference_(reference),
        session_(session),
        frames_(reference.T_reference_grid(), session.T_session_grid),
        options_(options),
        constraints_(constraints),
        deadline_(deadline),
        most_expansions_(most_expansions) {}

  SearchResult run() {
    if (const std::optional<SearchResult> unusable = checkInput(reference_, session_, options_)) {
      return *unusable;
    }
    Stage coarse("coarse", reference_.coarse());
    searchCoarse(coarse);
    result_.stages.push_back(coarse.report);
    if (!coarse.report.answered) {
      explainNoCoarseAnswer(coarse);
      return result_;
    }
    Stage fine("fine", reference_.fine());
    searchFine(fine, coarse);
    result_.stages.push_back(fine.report);
    if (fine.outcome.stopped) {
      stopped(fine);
      return result_;
    }
    answer(fine.report.answered ? fine : coarse, fine.report.answered);
    return result_;
  }

 private:
  // Algorithm 1 over all rotations at the coarse resolution.
  void searchCoarse(Stage& stage) {
    work::Stopwatch watch;
    stage.session = prepareSessionCells(session_.cells, session_.resolution, reference_.coarseResolution(),
                                        CellMerging::kMerge, options_.hits_sample_threshold);
    stage.report.rotation_step = rotationStep(options_.coarse.rotation_downsampling, stage.session.diagonal);
    stage.angles = allRotations(options_.coarse.rotation_downsampling, stage.session.diagonal);  // eq. 4.2, 4.3
    stage.problem.min_count = minCount(options_.coarse.acceptance_ratio, static_cast<int>(stage.session.points.size()));
    stage.problem.root_level = std::min(SearchReference::kCoarseRootLevel, downsamplingSteps(stage.session));
    stage.problem.threads = searchThreads(options_);
    stage.problem.most_expansions = most_expansions_;
    applyHeadingPrior(stage);
    for (const double angle : stage.angles) {
      stage.problem.windows.push_back(
          frames_.window(constraints_.window, stage.session.centre, stage.session.resolution, angle));
    }
    stage.problem.bands = rotationBands(stage.session, stage.angles);
    if (constraints_.heading) {
      putNearestFirst(stage.problem.bands);
    } else {
      putPromisingFirst(stage.problem, stage.session, kScoutCells, deadline_);
    }
    stage.report.initialization_time = watch.lap();
    record(stage, branchAndBound(stage.problem, deadline_));
  }

  // Algorithm 1 again, at the map's own resolution, around the coarse answer (report section 3.2).
  void searchFine(Stage& stage, const Stage& coarse) {
    work::Stopwatch watch;
    stage.session = session_.fine;
    stage.problem.root_level = SearchReference::kFineRootLevel;
    stage.problem.threads = searchThreads(options_);
    stage.problem.min_count = minCount(options_.fine.acceptance_ratio, static_cast<int>(stage.session.points.size()));
    const FineWindow window =
        fineWindow(coarse.session.resolution / stage.session.resolution, options_.coarse.rotation_downsampling,
                   rotationStep(options_.coarse.rotation_downsampling, coarse.session.diagonal));
    const double step = rotationStep(options_.fine.rotation_downsampling, stage.session.diagonal);
    stage.report.rotation_step = step;
    stage.report.initialization_time = watch.lap();
    CentrePose centre = poseOf(coarse);
    for (int search = 0; search < kMaxFineSearches; ++search) {
      watch.lap();
      placeWindow(stage, centre, window, step);
      stage.report.initialization_time += watch.lap();
      record(stage, branchAndBound(stage.problem, deadline_));
      if (!stage.report.answered || !onEdge(stage)) {
        break;
      }
      centre = poseOf(stage);
    }
  }

  void placeWindow(Stage& stage, const CentrePose& centre, const FineWindow& window, double step) const {
    stage.angles = rotationsAround(centre.angle, window.rotation_half_width, step);
    const Eigen::Vector2d middle = centre.position / stage.session.resolution;
    const grid::Cell cell{static_cast<int>(std::lround(middle.x())), static_cast<int>(std::lround(middle.y()))};
    stage.problem.windows.assign(stage.angles.size(), {{cell.x - window.half_width, cell.y - window.half_width},
                                                       {cell.x + window.half_width, cell.y + window.half_width}});
  }

  /// Whether the answer lies on the border of the window, so that a better one may lie beyond it.
  static bool onEdge(const Stage& stage) {
    const SearchPose& best = *stage.outcome.best;
    const SearchWindow& window = stage.problem.windows.front();
    return best.rotation + 2 >= static_cast<int>(stage.angles.size()) || best.translation.x == window.first.x ||
           best.translation.x == window.last.x || best.translation.y == window.first.y ||
           best.translation.y == window.last.y;
  }

  /// Leaves out the rotations that the prior excludes and ranks the others, nearest heading first.
  void applyHeadingPrior(Stage& stage) const {
    if (!constraints_.heading) {
      return;
    }
    std::vector<double>& angles = stage.angles;
    angles.erase(
        std::remove_if(angles.begin(), angles.end(),
                       [this](double angle) { return headingError(angle) > constraints_.heading->half_width; }),
        angles.end());
    std::stable_sort(angles.begin(), angles.end(),
                     [this](double a, double b) { return headingError(a) < headingError(b); });
    stage.problem.order.resize(angles.size());
    std::iota(stage.problem.order.begin(), stage.problem.order.end(), 0);
  }

  /// Puts the bands into the order of their nearest rotation; the rotations are in order already.
  static void putNearestFirst(std::vector<RotationBand>& bands) {
    const auto nearest = [](const RotationBand& band) {
      return *std::min_element(band.rotations.begin(), band.rotations.end());
    };
    std::sort(bands.begin(), bands.end(),
              [&](const RotationBand& a, const RotationBand& b) { return nearest(a) < nearest(b); });
  }

  double headingError(double angle) const { return frames_.headingError(*constraints_.heading, angle); }

  void stopped(const Stage& stage) {
    if (deadline_.stopped()) {
      end(SearchEnding::kStopped, "the search was stopped in its " + stage.report.name + " stage");
    } else {
      end(SearchEnding::kOutOfTime, "the time was over in the " + stage.report.name + " stage");
    }
  }

  void explainNoCoarseAnswer(const Stage& coarse) {
    if (coarse.outcome.stopped) {
      stopped(coarse);
      return;
    }
    std::ostringstream reason;
    reason << (coarse.outcome.gave_up ? "no pose was found soon that puts " : "no pose puts ")
           << options_.coarse.acceptance_ratio << " of the " << coarse.report.total_cells << " session cells of "
           << coarse.report.resolution << " m on walls of the reference map";
    end(SearchEnding::kSearched, reason.str());
  }

  void answer(const Stage& stage, bool refined) {
    result_.T_reference_session = frames_.mapPose(poseOf(stage), stage.session.centre);
    const Eigen::Vector3d intervals(stage.report.resolution, stage.report.resolution, stage.report.rotation_step);
    const Eigen::Matrix3d covariance =
        Eigen::Vector3d(intervals.array().square() / 12.0).asDiagonal();  // evenly spread
    result_.covariance = frames_.mapCovariance(covariance, poseOf(stage).angle, stage.session.centre);
    result_.refined = refined;
    result_.matched_cells = stage.report.matched_cells;
    result_.total_cells = stage.report.total_cells;
    result_.ratio = stage.report.ratio;
    std::ostringstream reason;
    reason << stage.report.matched_cells << " of " << stage.report.total_cells << " session cells lie on walls at "
           << stage.report.resolution << " m";
    if (!refined) {
      reason << "; the fine stage found no pose with " << options_.fine.acceptance_ratio
             << " of them, so the coarse answer stands";
    }
    result_.found = true;
    end(SearchEnding::kSearched, reason.str());
  }

  void end(SearchEnding ending, const std::string& reason) {
    result_.ending = ending;
    result_.reason = reason;
  }

  const SearchReference& reference_;
  const SearchSession& session_;
  SearchFrames frames_;
  const SearchOptions& options_;
  const Constraints& constraints_;
  const work::Deadline& deadline_;
  std::optional<std::int64_t> most_expansions_;  // of the coarse stage
  SearchResult result_;
};

}  // namespace

FineWindow fineWindow(double cells_per_coarse_cell, double coarse_rotation_downsampling, double coarse_rotation_step) {
  const double coarse_cells = 1.0 + std::sqrt(0.5) + 0.5 * coarse_rotation_downsampling;
  return {static_cast<int>(std::ceil(coarse_cells * cells_per_coarse_cell)), coarse_rotation_step};
}

SearchResult twoStageSearch(const SearchReference& reference, const SearchSession& session,
                            const SearchOptions& options, const Constraints& constraints,
                            const work::Deadline& deadline, std::optional<std::int64_t> most_expansions) {
  return TwoStageSearch(reference, session, options, constraints, deadline, most_expansions).run();
}

}  // namespace map_matcher::search
