#include "map_matcher/belief/agreement.hpp"

#include <sstream>

#include "pose_text.hpp"

namespace map_matcher::belief {
namespace {

/// The pose as the search compares places: in whole cells.
const grid::Rigid2& wholePose(const search::SearchResult& result) {
  return result.searched ? *result.searched : result.T_reference_session;
}

bool isSamePlace(const search::SearchResult& result, const search::SearchOptions& options,
                 const grid::Rigid2& T_reference_session) {
  const search::PlaceDifference difference =
      search::difference(wholePose(result), T_reference_session, result.session_centre);
  return difference.distance <= options.distinct_distance && difference.angle <= options.distinct_angle;
}

}  // namespace

Standing standingOf(const search::SearchResult& result, const search::SearchOptions& options,
                    const std::optional<grid::Rigid2>& alignment, const std::optional<grid::Rigid2>& contender) {
  if (!alignment) {
    return Standing::kFirst;
  }
  if (isSamePlace(result, options, *alignment)) {
    return Standing::kAgrees;
  }
  return contender && isSamePlace(result, options, *contender) ? Standing::kConfirms : Standing::kContradicts;
}

Evidence agreementEvidence(const search::SearchResult& result, const MatchOptions& options, Standing standing,
                           const std::optional<grid::Rigid2>& alignment) {
  Evidence evidence;
  evidence.name = "agreement";
  evidence.limit = options.search.distinct_distance;
  evidence.objection = MatchStatus::kUnconfirmed;
  if (alignment) {
    evidence.value = search::difference(wholePose(result), *alignment, result.session_centre).distance;
  }
  switch (standing) {
    case Standing::kFirst:
      evidence.text = "no earlier map of the session was matched";
      break;
    case Standing::kAgrees:
      evidence.bearing = Bearing::kFor;
      evidence.text = "it is the place of an earlier session map";
      break;
    case Standing::kConfirms:
      evidence.bearing = Bearing::kFor;
      evidence.text = "it is the place of the session map before, though not that of earlier ones";
      break;
    case Standing::kContradicts:
      evidence.bearing = options.belief.confirm_relocation ? Bearing::kAgainst : Bearing::kSilent;
      evidence.text = "an earlier map of the session was matched at another place, " + poseText(*alignment) +
                      ": the next one has to confirm which it is";
      break;
  }
  return evidence;
}

}  // namespace map_matcher::belief
