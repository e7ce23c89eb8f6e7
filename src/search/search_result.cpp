#include "map_matcher/search/search_result.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::search {

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
