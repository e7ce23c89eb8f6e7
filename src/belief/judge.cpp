#include "map_matcher/belief/judge.hpp"

#include "map_matcher/belief/agreement.hpp"
#include "map_matcher/belief/place_evidence.hpp"
#include "map_matcher/belief/probability.hpp"
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

/// What the search says, of a place that was searched with a proof.
std::vector<Evidence> gatherProven(const Findings& findings, const MatchOptions& options, bool confirmed,
                                   bool follows) {
  const search::SearchResult& result = findings.search;
  std::vector<Evidence> evidence{proofEvidence(result, options), hitEvidence(result, options),
                                 marginEvidence(findings, options, follows)};
  if (!findings.candidates.empty()) {
    for (Evidence& piece : freeSpaceEvidence(findings.candidates.front().space)) {
      evidence.push_back(std::move(piece));
    }
    evidence.push_back(probabilityEvidence(probabilityOf(findings), options.belief, confirmed, follows));
  }
  return evidence;
}

std::vector<Evidence> gather(const Findings& findings, const MatchOptions& options,
                             const Circumstances& circumstances) {
  const search::SearchResult& result = findings.search;
  std::vector<Evidence> evidence;
  if (findings.followed) {
    evidence.push_back(followedEvidence(findings));
    for (Evidence& piece : freeSpaceEvidence(findings.candidates.front().space)) {
      evidence.push_back(std::move(piece));
    }
  } else if (!result.exact) {
    return {ratioEvidence(result, options)};
  }
  const Standing standing = result.found
                                ? standingOf(findings, options.search, circumstances.alignment, circumstances.contender)
                                : Standing::kFirst;
  if (!findings.followed) {
    const bool follows = standing == Standing::kAgrees && options.belief.follow_alignment;
    const bool confirmed = circumstances.tentative && result.found &&
                           standingOf(findings, options.search, circumstances.tentative, {}) == Standing::kAgrees;
    evidence = gatherProven(findings, options, confirmed, follows);
  }
  if (result.found) {
    evidence.push_back(agreementEvidence(findings, options, standing, circumstances.alignment));
  }
  if (circumstances.prior) {
    evidence.push_back(*circumstances.prior);
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
  for (const char* name : {"ratio", "followed", "hit_ratio", "agreement", "margin", "probability"}) {
    const Evidence* piece = find(evidence, name);
    const bool first_map = piece != nullptr && piece->name == "agreement" && piece->bearing == Bearing::kSilent;
    if (piece != nullptr && !first_map) {
      reason += (reason.empty() ? "" : "; ") + piece->text;
    }
  }
  return reason;
}

}  // namespace

Answer judge(const Findings& findings, const MatchOptions& options, const Circumstances& circumstances) {
  const search::SearchResult& result = findings.search;
  Answer answer;
  answer.search = result;
  answer.map = findings.map;
  answer.candidates = findings.candidates;
  answer.probability = findings.followed ? circumstances.probability : probabilityOf(findings);
  if (!result.ended()) {
    answer.status = statusWithoutSearch(result.ending);
    answer.reason = result.reason;
    return answer;
  }
  answer.evidence = gather(findings, options, circumstances);
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
