#include "map_matcher/search/search_result.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::search {

void setAnswer(SearchResult& result, const Place& place) {
  result.found = true;
  result.refined = true;
  result.T_reference_session = place.T_reference_session;
  result.searched = place.searched;
  result.covariance = place.covariance;
  result.matched_cells = place.matched_cells;
  result.ratio = static_cast<double>(place.matched_cells) / result.total_cells;
  result.hit_cells = place.hit_cells;
  result.hit_ratio = place.hit_ratio;
}

const StageReport* stageOf(const SearchResult& result, const std::string& name) {
  const auto found = std::find_if(result.stages.begin(), result.stages.end(),
                                  [&name](const StageReport& stage) { return stage.name == name; });
  return found != result.stages.end() ? &*found : nullptr;
}

PlaceDifference difference(const grid::Rigid2& T_a_session, const grid::Rigid2& T_b_session,
                           const Eigen::Vector2d& session_centre) {
  return {(T_a_session * session_centre - T_b_session * session_centre).norm(),
          std::abs(grid::normalizeAngle(T_a_session.yaw - T_b_session.yaw))};
}

}  // namespace map_matcher::search
