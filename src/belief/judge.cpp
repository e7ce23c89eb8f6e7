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

void append(std::vector<Evidence>& evidence, const std::vector<Evidence>& more) {
  evidence.insert(evidence.end(), more.begin(), more.end());
}

/// What the search says of the place.
std::vector<Evidence> gatherSearched(const Findings& findings, double probability, const MatchOptions& options,
                                     Standing standing, const std::optional<KnownPlace>& tentative) {
  const search::SearchResult& result = findings.search;
  const bool follows = standing == Standing::kAgrees && options.belief.follow_alignment;
  std::vector<Evidence> evidence;
  if (findings.followed) {
    evidence = {followedEvidence(findings)};
  } else {
    evidence = {proofEvidence(result, options), hitEvidence(result, options),
                marginEvidence(findings, options, follows)};
  }
  if (!findings.candidates.empty()) {
    append(evidence, freeSpaceEvidence(findings.candidates.front().space));
  }
  if (!findings.candidates.empty() && !findings.followed) {
    const bool confirmed = tentative && result.found && isSamePlace(findings, options.search, *tentative);
    evidence.push_back(probabilityEvidence(probability, options.belief, confirmed, follows));
  }
  return evidence;
}

std::vector<Evidence> gather(const Findings& findings, double probability, const MatchOptions& options,
                             const Circumstances& circumstances) {
  const search::SearchResult& result = findings.search;
  if (!findings.followed && !result.exact) {
    return {ratioEvidence(result, options)};
  }
  const Standing standing = result.found
                                ? standingOf(findings, options.search, circumstances.alignment, circumstances.contender)
                                : Standing::kFirst;
  std::vector<Evidence> evidence = gatherSearched(findings, probability, options, standing, circumstances.tentative);
  if (result.found) {
    evidence.push_back(agreementEvidence(findings, options, standing, circumstances.alignment));
  }
  if (circumstances.prior) {
    evidence.push_back(*circumstances.prior);
  }
  if (circumstances.nearby) {
    append(evidence, surroundingsEvidence(*circumstances.nearby, options.belief, circumstances.robot_was_lost));
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
  answer.evidence = gather(findings, answer.probability, options, circumstances);
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
