/// \file
/// What can be chosen about a match: how places are searched, and what they have to show.
#pragma once

#include "map_matcher/belief/belief_options.hpp"
#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/search/demand.hpp"
#include "map_matcher/search/search_options.hpp"

namespace map_matcher::belief {

/// Options of the search and of the judgement of what it finds.
struct MatchOptions {
  search::SearchOptions search;
  BeliefOptions belief;
};

/// What the judge has to know of a search: all that reaches min_hit_ratio, and what comes within min_margin of the
/// best, or near enough to make it less likely.
search::Demand demandOf(const MatchOptions& options);

/// The parameters that fill `options`, by the names they have in config/map_matcher.yaml.
parameters::ParameterList parametersOf(MatchOptions& options);

}  // namespace map_matcher::belief
