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

std::optional<grid::Rigid2> TrialQuery::candidate() const {
  return answer.search.found ? std::optional<grid::Rigid2>(answer.search.T_reference_session) : std::nullopt;
}

std::optional<evaluation::PoseError> TrialQuery::candidateError() const {
  if (!candidate() || !truth) {
    return std::nullopt;
  }
  return evaluation::errorOf(*candidate() * T_session_base, *truth);
}

std::optional<search::PlaceDifference> TrialQuery::candidateMapError() const {
  if (!candidate() || !true_alignment) {
    return std::nullopt;
  }
  return search::difference(*candidate(), *true_alignment, answer.search.session_centre);
}

}  // namespace map_matcher::trials
