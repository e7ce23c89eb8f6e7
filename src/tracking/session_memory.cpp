#include "map_matcher/tracking/session_memory.hpp"

namespace map_matcher {

void SessionMemory::add(const MatchResult& result) {
  switch (result.status) {
    case MatchStatus::kMatched:
      prior_.alignment = result.T_reference_session;
      prior_.contender.reset();
      prior_.robot_astray = false;
      break;
    case MatchStatus::kRobotAstray:
      prior_.contender.reset();
      prior_.robot_astray = true;
      break;
    case MatchStatus::kUnconfirmed:
      prior_.contender = result.T_reference_session;
      break;
    case MatchStatus::kBelowAcceptanceRatio:
    case MatchStatus::kNotCertified:
    case MatchStatus::kAmbiguous:
      prior_.contender.reset();
      break;
    case MatchStatus::kNoReference:
    case MatchStatus::kEmptyReference:
    case MatchStatus::kTooFewSessionCells:
    case MatchStatus::kSessionTooLarge:
    case MatchStatus::kStopped:
      break;  // the map was not searched
  }
}

}  // namespace map_matcher
