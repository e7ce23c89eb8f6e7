/// \file
/// Which matches are believed.
#pragma once

#include <string>

#include "map_matcher/search/match_options.hpp"
#include "map_matcher/search/match_result.hpp"

namespace map_matcher::search {

/// What is to be made of the outcome of an exact search.
struct Verdict {
  MatchStatus status = MatchStatus::kNotCertified;
  std::string reason;  ///< One sentence with the figures, and both candidates where they are at odds.
};

/// How a place stands to what earlier maps of the session said.
enum class Standing {
  kFirst,        ///< None of them was accepted.
  kAgrees,       ///< The place is MatchPrior::alignment.
  kConfirms,     ///< It is another one, but MatchPrior::contender.
  kContradicts,  ///< It is neither.
};

/// kMatched when the result is certified, its hit ratio reaches smallestHitRatio() and its margin min_margin, and it
/// contradicts no earlier map; else the first of these that fails. The margin counts only once the runner-up is proven.
/// A place that agrees needs no margin with options.follow_alignment, and one that contradicts is kUnconfirmed with
/// options.confirm_relocation. `result` has an answer of an exact search in it. A wrong pose that looks right is worse
/// than none: what is not proven is not accepted, and of a search that a deadline ended nothing is said that the whole
/// search may not say.
Verdict judge(const MatchResult& result, const MatchOptions& options, Standing standing = Standing::kFirst);

}  // namespace map_matcher::search
