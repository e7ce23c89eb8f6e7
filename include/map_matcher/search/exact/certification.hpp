/// \file
/// The proof that a match is the best one, and whether it may be accepted.
#pragma once

#include "map_matcher/search/match_options.hpp"
#include "map_matcher/search/match_prior.hpp"
#include "map_matcher/search/match_result.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_session.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// Searches all poses that the priors allow, at the map's own resolution, beginning with the score of the two stages'
/// answer: that is proven to be the best, or replaced by the better one. Finds the best place elsewhere as well, and
/// accepts the answer if it stands out. `answer` is what the two stages found, a pose or nothing; if they did not
/// search at all, it is returned as it is. Returns within 50 ms of the deadline.
MatchResult certify(const MatchResult& answer, const SearchReference& reference, const SearchSession& session,
                    const MatchOptions& options, const MatchPrior& prior, const work::Deadline& deadline);

}  // namespace map_matcher::search
