/// \file
/// The proof that a place is the best one, and the best place elsewhere.
#pragma once

#include "map_matcher/search/constraints.hpp"
#include "map_matcher/search/demand.hpp"
#include "map_matcher/search/search_options.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_result.hpp"
#include "map_matcher/search/search_session.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// Searches all poses that the constraints allow, at the map's own resolution, beginning with the score of the two
/// stages' answer, or of one of the demand's starts: that is proven to be the best, or replaced by the better one.
/// Finds the best place elsewhere as well, as far as `demand` asks, and moves a pose that is proven from whole cells to
/// where it fits best. `answer` is what the two stages found, a pose or nothing; if they did not search at all, it is
/// returned as it is. Returns within 50 ms of the deadline.
SearchResult certify(const SearchResult& answer, const SearchReference& reference, const SearchSession& session,
                     const SearchOptions& options, const Demand& demand, const Constraints& constraints,
                     const work::Deadline& deadline);

}  // namespace map_matcher::search
