#include "map_matcher/belief/session_memory.hpp"

namespace map_matcher::belief {

void SessionMemory::add(const search::MatchResult& result) {
  switch (result.status) {
    case search::MatchStatus::kMatched:
      prior_.alignment = result.T_reference_session;
      prior_.contender.reset();
      prior_.robot_astray = false;
      break;
    case search::MatchStatus::kRobotAstray:
      prior_.contender.reset();
      prior_.robot_astray = true;
      break;
    case search::MatchStatus::kUnconfirmed:
      prior_.contender = result.T_reference_session;
      break;
    case search::MatchStatus::kBelowAcceptanceRatio:
    case search::MatchStatus::kNotCertified:
    case search::MatchStatus::kAmbiguous:
      prior_.contender.reset();
      break;
    case search::MatchStatus::kNoReference:
    case search::MatchStatus::kEmptyReference:
    case search::MatchStatus::kTooFewSessionCells:
    case search::MatchStatus::kSessionTooLarge:
    case search::MatchStatus::kStopped:
      break;  // the map was not searched
  }
}

}  // namespace map_matcher::belief
