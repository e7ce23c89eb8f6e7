#include "map_matcher/belief/agreement.hpp"

#include <sstream>

#include "pose_text.hpp"

namespace map_matcher::belief {
namespace {

/// The pose as the search compares places: in whole cells.
const grid::Rigid2& wholePose(const search::SearchResult& result) {
  return result.searched ? *result.searched : result.T_reference_session;
}

bool isSamePose(const grid::Rigid2& a, const grid::Rigid2& b, const Eigen::Vector2d& session_centre,
                const search::SearchOptions& options) {
  const search::PlaceDifference difference = search::difference(a, b, session_centre);
  return difference.distance <= options.distinct_distance && difference.angle <= options.distinct_angle;
}

}  // namespace

bool isSamePlace(const Findings& findings, const search::SearchOptions& options, const KnownPlace& place) {
  return findings.map == place.map &&
         isSamePose(wholePose(findings.search), place.T_reference_session, findings.search.session_centre, options);
}

bool isAt(const Candidate& candidate, const Eigen::Vector2d& session_centre, const KnownPlace& place,
          const search::SearchOptions& options) {
  return candidate.map == place.map &&
         isSamePose(candidate.place.searched, place.T_reference_session, session_centre, options);
}

Standing standingOf(const Findings& findings, const search::SearchOptions& options,
                    const std::optional<KnownPlace>& alignment, const std::optional<KnownPlace>& contender) {
  if (!alignment) {
    return Standing::kFirst;
  }
  if (isSamePlace(findings, options, *alignment)) {
    return Standing::kAgrees;
  }
  return contender && isSamePlace(findings, options, *contender) ? Standing::kConfirms : Standing::kContradicts;
}

Evidence agreementEvidence(const Findings& findings, const MatchOptions& options, Standing standing,
                           const std::optional<KnownPlace>& alignment) {
  Evidence evidence;
  evidence.name = "agreement";
  evidence.limit = options.search.distinct_distance;
  evidence.objection = MatchStatus::kUnconfirmed;
  if (alignment && alignment->map == findings.map) {
    const search::SearchResult& result = findings.search;
    evidence.value =
        search::difference(wholePose(result), alignment->T_reference_session, result.session_centre).distance;
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
      evidence.text = "an earlier map of the session was matched at another place, " +
                      poseText(alignment->T_reference_session) + ": the next one has to confirm which it is";
      break;
  }
  return evidence;
}

}  // namespace map_matcher::belief
