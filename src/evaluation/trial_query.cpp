#include "map_matcher/evaluation/trial_query.hpp"

namespace map_matcher {

std::optional<Rigid2> TrialQuery::alignment() const {
  if (!result.matched()) {
    return std::nullopt;
  }
  return result.T_reference_session;
}

std::optional<Rigid2> TrialQuery::estimate() const {
  if (!result.matched()) {
    return std::nullopt;
  }
  return result.T_reference_session * T_session_base;
}

std::optional<PoseError> TrialQuery::robotError() const {
  const std::optional<Rigid2> pose = estimate();
  return pose && truth ? std::optional<PoseError>(errorOf(*pose, *truth)) : std::nullopt;
}

}  // namespace map_matcher
