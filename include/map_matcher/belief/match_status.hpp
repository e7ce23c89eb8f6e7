/// \file
/// What a match comes to, in one word.
#pragma once

namespace map_matcher::belief {

/// What is to be made of a session map.
enum class MatchStatus {
  kMatched,               ///< There is a pose that may be relied on.
  kBelowAcceptanceRatio,  ///< No pose reaches the acceptance ratio; with the exact search, that is proven.
  kNoReference,           ///< There is no reference map.
  kEmptyReference,        ///< The reference map has no occupied cell.
  kTooFewSessionCells,    ///< The session map has fewer than min_session_cells occupied cells.
  kSessionTooLarge,       ///< The session map is too large for the search's arithmetic.
  kStopped,               ///< The search was stopped before there was an answer.
  kNotCertified,          ///< The deadline came before the end of the search, or of its proof.
  kAmbiguous,             ///< A place elsewhere matches nearly as well.
  kDoubtful,     ///< No place elsewhere matches as well, but the place itself is not likely enough to be right.
  kUnconfirmed,  ///< The place is good enough, but another than that of an earlier map of the session.
  kRobotLost,    ///< The map fits, but not where the robot is: the mapper has lost it.
};

/// The status in snake_case, as JSON output and messages have it ("matched", "below_acceptance_ratio", ...).
const char* toString(MatchStatus status);

}  // namespace map_matcher::belief
