#include "map_matcher/search/following/following.hpp"

#include <cmath>
#include <optional>
#include <sstream>

#include "../exact/climbing.hpp"
#include "../input_check.hpp"
#include "../placing.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

/// All rotations, one by one.
RotationBlocks allRotationsOf(const SessionCells& cells) {
  const double step = rotationStep(1.0, cells.diagonal);
  constexpr int kTopLevel = 0;
  return {cells, 0.0, step, static_cast<int>(std::lround(2.0 * M_PI / step)), kTopLevel};
}

StageReport reportOf(const RotationBlocks& rotations, const SessionCells& cells, int hits) {
  StageReport stage;
  stage.name = "follow";
  stage.resolution = cells.resolution;
  stage.rotations = rotations.count();
  stage.rotation_step = rotations.step();
  stage.matched_cells = hits;
  stage.total_cells = rotations.numCells();
  stage.ratio = static_cast<double>(hits) / stage.total_cells;
  return stage;
}

}  // namespace

SearchResult followPlace(const SearchReference& reference, const SearchSession& session, const SearchOptions& options,
                         const grid::Rigid2& T_reference_session, const Demand& demand,
                         const work::Deadline& deadline) {
  if (const std::optional<SearchResult> unusable = checkInput(reference, session, options)) {
    return *unusable;
  }
  work::Stopwatch watch;
  const SessionCells& cells = session.fine;
  const RotationBlocks rotations = allRotationsOf(cells);
  const Placing placing(reference, session, options, rotations);
  const SearchFrames frames(reference.T_reference_grid(), session.T_session_grid);
  const ExactProblem problem{reference.exact(), rotations};
  const double preparation_time = watch.lap();
  const std::optional<SearchPose> pose =
      climbFrom(frames.centrePose(T_reference_session, cells.centre), cells.resolution, problem, deadline);
  SearchResult result;
  result.exact = true;
  result.total_cells = rotations.numCells();
  result.session_centre = session.T_session_grid * cells.centre;
  StageReport stage = reportOf(rotations, cells, pose ? pose->count : 0);
  stage.answered = pose && pose->count >= minCount(demand.min_hit_ratio, result.total_cells);
  stage.initialization_time = preparation_time;
  stage.depth_first_search_time = watch.lap();
  if (stage.answered) {
    Place place = placing.placeOf(*pose);
    place.worth = demand.worth ? demand.worth(place) : place.worth;
    setAnswer(result, place);
    result.places.push_back(place);
  }
  std::ostringstream reason;
  reason << stage.matched_cells << " of " << stage.total_cells << " session cells lie near walls at the best pose near "
         << "that of an earlier session map";
  result.reason = reason.str();
  if (deadline.passed()) {
    result.ending = deadline.stopped() ? SearchEnding::kStopped : SearchEnding::kOutOfTime;
  }
  result.stages.push_back(stage);
  return result;
}

}  // namespace map_matcher::search
