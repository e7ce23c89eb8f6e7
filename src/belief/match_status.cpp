#include "map_matcher/belief/match_status.hpp"

namespace map_matcher::belief {

const char* toString(MatchStatus status) {
  switch (status) {
    case MatchStatus::kMatched:
      return "matched";
    case MatchStatus::kBelowAcceptanceRatio:
      return "below_acceptance_ratio";
    case MatchStatus::kNoReference:
      return "no_reference";
    case MatchStatus::kEmptyReference:
      return "empty_reference";
    case MatchStatus::kTooFewSessionCells:
      return "too_few_session_cells";
    case MatchStatus::kSessionTooLarge:
      return "session_too_large";
    case MatchStatus::kStopped:
      return "stopped";
    case MatchStatus::kNotCertified:
      return "not_certified";
    case MatchStatus::kAmbiguous:
      return "ambiguous";
    case MatchStatus::kDoubtful:
      return "doubtful";
    case MatchStatus::kUnconfirmed:
      return "unconfirmed";
    case MatchStatus::kRobotLost:
      return "robot_lost";
  }
  return "unknown";
}

}  // namespace map_matcher::belief
