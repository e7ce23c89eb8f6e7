#include "map_matcher/trials/trial_query.hpp"

namespace map_matcher::trials {

std::optional<grid::Rigid2> TrialQuery::alignment() const { return answer.alignment(); }

std::optional<grid::Rigid2> TrialQuery::estimate() const {
  const std::optional<grid::Rigid2> T_reference_session = alignment();
  return T_reference_session ? std::optional<grid::Rigid2>(*T_reference_session * T_session_base) : std::nullopt;
}

std::optional<evaluation::PoseError> TrialQuery::robotError() const {
  const std::optional<grid::Rigid2> pose = estimate();
  return pose && truth ? std::optional<evaluation::PoseError>(evaluation::errorOf(*pose, *truth)) : std::nullopt;
}

}  // namespace map_matcher::trials
