#include "map_matcher/belief/session_tracker.hpp"

namespace map_matcher::belief {

std::string SessionTracker::arrive(const SessionMapTraits& traits) {
  std::string why = last_map_ ? whyAnotherSession(*last_map_, traits) : "";
  if (!why.empty()) {
    reset();
  }
  last_map_ = traits;
  return why;
}

Decision SessionTracker::conclude(const search::SearchResult& result, const search::Reference& reference,
                                  const grid::OccupancyGrid& map, const std::optional<Eigen::Vector2d>& robot) {
  const std::uint64_t digest = digestOf(map);
  Circumstances circumstances;
  circumstances.alignment = alignment_;
  circumstances.robot_was_lost = robot_was_lost_;
  if (contender_ && contender_->digest != digest) {
    circumstances.contender = contender_->T_reference_session;
  }
  if (result.exact && result.found && (robot || robot_was_lost_)) {  // what is not seen takes nothing back
    circumstances.nearby =
        robot ? surroundings(reference, map, options_, result.T_reference_session, *robot) : Surroundings{};
  }
  Decision decision;
  decision.answer = judge(result, options_, circumstances);
  decision.broadcast = remember(decision.answer, digest);
  return decision;
}

void SessionTracker::reset() {
  last_map_.reset();
  alignment_.reset();
  contender_.reset();
  prior_.reset();
  robot_was_lost_ = false;
}

Broadcast SessionTracker::remember(const Answer& answer, std::uint64_t digest) {
  switch (answer.status) {
    case MatchStatus::kMatched:
      alignment_ = answer.search.T_reference_session;
      contender_.reset();
      robot_was_lost_ = false;
      return Broadcast::kReplace;
    case MatchStatus::kRobotLost:
      contender_.reset();
      robot_was_lost_ = true;
      return Broadcast::kWithdraw;
    case MatchStatus::kUnconfirmed:
      contender_ = Contender{answer.search.T_reference_session, digest};
      break;
    case MatchStatus::kBelowAcceptanceRatio:
    case MatchStatus::kNotCertified:
    case MatchStatus::kAmbiguous:
      contender_.reset();
      break;
    case MatchStatus::kNoReference:
    case MatchStatus::kEmptyReference:
    case MatchStatus::kTooFewSessionCells:
    case MatchStatus::kSessionTooLarge:
    case MatchStatus::kStopped:
      break;  // the map was not searched
  }
  return Broadcast::kKeep;
}

}  // namespace map_matcher::belief
