/// \file
/// A place that is known from an earlier session map.
#pragma once

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/search/demand.hpp"
#include "map_matcher/search/search_options.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_result.hpp"
#include "map_matcher/search/search_session.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// The best pose uphill, by hits, from a pose that the session map is known to lie near, moved to where it fits best:
/// found when it has the hits that `demand` asks for. There is no proof, and nothing is said of places elsewhere.
SearchResult followPlace(const SearchReference& reference, const SearchSession& session, const SearchOptions& options,
                         const grid::Rigid2& T_reference_session, const Demand& demand, const work::Deadline& deadline);

}  // namespace map_matcher::search
