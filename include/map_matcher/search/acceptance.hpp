/// \file
/// Which matches are believed.
#pragma once

#include <string>

#include "map_matcher/search/match_options.hpp"
#include "map_matcher/search/match_result.hpp"

namespace map_matcher {

/// What is to be made of the outcome of an exact search.
struct Verdict {
  MatchStatus status = MatchStatus::kNotCertified;
  std::string reason;  ///< One sentence with the figures, and both candidates where they are at odds.
};

/// kMatched when the result is certified, its hit ratio reaches smallestHitRatio() and its margin min_margin; else
/// the first of these that fails. `agrees`: whether the place is that of MatchPrior::alignment, which replaces the
/// margin with options.follow_alignment. `result` has an answer of an exact search in it. A wrong pose that looks right
/// is worse than none: what is not proven is not accepted.
Verdict judge(const MatchResult& result, const MatchOptions& options, bool agrees = false);

}  // namespace map_matcher
