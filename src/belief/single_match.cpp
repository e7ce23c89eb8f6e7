#include "map_matcher/belief/single_match.hpp"

#include "map_matcher/belief/judge.hpp"
#include "map_matcher/belief/place_search.hpp"
#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/search/map_matcher.hpp"

namespace map_matcher::belief {
namespace {

void requireValid(MatchOptions options) { parameters::throwIfAny(parameters::problemsOf(parametersOf(options))); }

}  // namespace

Answer matchAlone(const ReferenceMaps& maps, const grid::OccupancyGrid& session, const MatchOptions& options,
                  const search::Constraints& constraints, const work::StopToken& stop) {
  requireValid(options);
  const search::MapMatcher matcher(options.search);
  return judge(findPlaces(matcher, maps, session, options, {}, constraints, stop), options);
}

Answer matchAlone(const ReferenceMaps& maps, const grid::OccupancyGrid& session, const MatchOptions& options,
                  const search::Constraints& constraints, const work::Deadline& deadline) {
  requireValid(options);
  const search::MapMatcher matcher(options.search);
  return judge(findPlaces(matcher, maps, session, options, {}, constraints, deadline), options);
}

}  // namespace map_matcher::belief
