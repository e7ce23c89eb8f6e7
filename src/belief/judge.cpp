#include "map_matcher/belief/judge.hpp"

#include "map_matcher/belief/agreement.hpp"
#include "map_matcher/belief/search_evidence.hpp"

namespace map_matcher::belief {
namespace {

/// The answer when nothing was searched to the end.
MatchStatus statusWithoutSearch(search::SearchEnding ending) {
  switch (ending) {
    case search::SearchEnding::kEmptyReference:
      return MatchStatus::kEmptyReference;
    case search::SearchEnding::kTooFewSessionCells:
      return MatchStatus::kTooFewSessionCells;
    case search::SearchEnding::kSessionTooLarge:
      return MatchStatus::kSessionTooLarge;
    case search::SearchEnding::kStopped:
    case search::SearchEnding::kSearched:
    case search::SearchEnding::kOutOfTime:
      break;
  }
  return MatchStatus::kStopped;
}

std::vector<Evidence> gather(const search::SearchResult& result, const MatchOptions& options,
                             const Circumstances& circumstances) {
  if (!result.exact) {
    return {ratioEvidence(result, options)};
  }
  const Standing standing = result.found
                                ? standingOf(result, options.search, circumstances.alignment, circumstances.contender)
                                : Standing::kFirst;
  const bool follows = standing == Standing::kAgrees && options.belief.follow_alignment;
  std::vector<Evidence> evidence{proofEvidence(result, options), hitEvidence(result, options),
                                 marginEvidence(result, options, follows)};
  if (result.found) {
    evidence.push_back(agreementEvidence(result, options, standing, circumstances.alignment));
  }
  if (circumstances.nearby) {
    for (Evidence& piece : surroundingsEvidence(*circumstances.nearby, options.belief, circumstances.robot_was_lost)) {
      evidence.push_back(std::move(piece));
    }
  }
  return evidence;
}

/// Why a place is relied on.
std::string matchedReason(const std::vector<Evidence>& evidence) {
  std::string reason;
  for (const char* name : {"ratio", "hit_ratio", "agreement", "margin"}) {
    const Evidence* piece = find(evidence, name);
    const bool first_map = piece != nullptr && piece->name == "agreement" && piece->bearing == Bearing::kSilent;
    if (piece != nullptr && !first_map) {
      reason += (reason.empty() ? "" : "; ") + piece->text;
    }
  }
  return reason;
}

}  // namespace

Answer judge(const search::SearchResult& result, const MatchOptions& options, const Circumstances& circumstances) {
  Answer answer;
  answer.search = result;
  if (!result.ended()) {
    answer.status = statusWithoutSearch(result.ending);
    answer.reason = result.reason;
    return answer;
  }
  answer.evidence = gather(result, options, circumstances);
  answer.nearby = circumstances.nearby.value_or(Surroundings{});
  if (const Evidence* objection = firstAgainst(answer.evidence)) {
    answer.status = objection->objection;
    answer.reason = objection->text;
  } else {
    answer.status = MatchStatus::kMatched;
    answer.reason = matchedReason(answer.evidence);
  }
  return answer;
}

}  // namespace map_matcher::belief
