/// \file
/// Finds the places of a session map, with the evidence for each.
#pragma once

#include <optional>
#include <vector>

#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/known_place.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/prior.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/work/deadline.hpp"
#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::belief {

/// The reference maps that are searched, by their numbers: floors or buildings. Not null, at least one.
using ReferenceMaps = std::vector<const search::Reference*>;

/// Where to look, and in what order.
struct Plan {
  std::optional<KnownPlace> follow;  ///< The place in use: the whole search only if it does not hold.
  double worth = 0.0;                ///< Of it, when it was last proven or followed.
  std::vector<KnownPlace> starts{};  ///< Where the whole search begins: search::Demand::starts. The likeliest first.
};

/// Searches the plan's place, and if that does not hold any more, or there is none, all of `maps`, one after the other,
/// the most likely one first, and the next one only for what can still matter beside the best place so far. Ends
/// SearchOptions::exact_deadline after the reference maps are prepared. Throws what search::MapMatcher::match throws.
Findings findPlaces(const search::MapMatcher& matcher, const ReferenceMaps& maps, const grid::OccupancyGrid& session,
                    const MatchOptions& options, const Plan& plan = {}, const search::Constraints& constraints = {},
                    const work::StopToken& stop = {});

/// The whole search alone, from these starts on, with a deadline of the caller's.
Findings findPlaces(const search::MapMatcher& matcher, const ReferenceMaps& maps, const grid::OccupancyGrid& session,
                    const MatchOptions& options, const std::vector<KnownPlace>& starts,
                    const search::Constraints& constraints, const work::Deadline& deadline);

/// How much less than before a place that is followed may be worth.
constexpr double kFollowedLoss = 0.1;

}  // namespace map_matcher::belief
