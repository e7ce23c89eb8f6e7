#include "map_matcher/search/map_matcher.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/search/exact/certification.hpp"
#include "map_matcher/search/following/following.hpp"
#include "map_matcher/search/search_session.hpp"
#include "map_matcher/search/two_stage/two_stage_search.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

/// Nodes that the coarse stage expands at most before the exact search begins without an answer of it. In the right
/// building it needs 6 to 200, but in another one it would take longer than the exact search (benchmark: BM_Certified).
constexpr std::int64_t kMostExpansions = 2000;

SearchResult stoppedBefore() {
  SearchResult stopped;
  stopped.ending = SearchEnding::kStopped;
  stopped.reason = "the search was stopped while the reference map was prepared";
  return stopped;
}

}  // namespace

MapMatcher::MapMatcher(const SearchOptions& options) : options_(options) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options_)));
}

SearchResult MapMatcher::match(const Reference& reference, const grid::OccupancyGrid& session, const Demand& demand,
                               const Constraints& constraints, const work::StopToken& stop) const {
  const Reference::Prepared prepared = reference.at(session.resolution(), stop);
  return search(prepared, session, demand, constraints, work::Deadline(options_.exact_deadline, stop));
}

SearchResult MapMatcher::match(const Reference& reference, const grid::OccupancyGrid& session, const Demand& demand,
                               const Constraints& constraints, const work::Deadline& deadline) const {
  return search(reference.at(session.resolution(), deadline.stop()), session, demand, constraints, deadline);
}

SearchResult MapMatcher::search(const Reference::Prepared& prepared, const grid::OccupancyGrid& session,
                                const Demand& demand, const Constraints& constraints,
                                const work::Deadline& deadline) const {
  if (!prepared.map) {
    return stoppedBefore();
  }
  work::Stopwatch watch;
  const SearchSession search_session = searchSession(session, prepared.map->resolution(), options_);
  SearchResult result = begin(prepared, search_session, demand, constraints, deadline);
  if (options_.search == "exact") {
    result = certify(result, *prepared.map, search_session, options_, demand, constraints, deadline);
  }
  result.search_time = watch.lap();
  result.reference_time = prepared.time;
  return result;
}

/// Sections 3.1 and 3.2 of the report: the coarse stage everywhere, then the fine one around its answer.
SearchResult MapMatcher::begin(const Reference::Prepared& prepared, const SearchSession& session, const Demand& demand,
                               const Constraints& constraints, const work::Deadline& deadline) const {
  SearchOptions options = options_;
  std::optional<std::int64_t> most_expansions;
  if (options.search == "exact") {  // the two stages find where the exact search begins, in a crowd, too
    options.coarse.acceptance_ratio = std::min(options.coarse.acceptance_ratio, demand.min_hit_ratio);
    most_expansions = kMostExpansions;
  }
  return twoStageSearch(*prepared.map, session, options, constraints, deadline, most_expansions);
}

SearchResult MapMatcher::glance(const Reference& reference, const grid::OccupancyGrid& session, const Demand& demand,
                                const Constraints& constraints, const work::Deadline& deadline) const {
  const Reference::Prepared prepared = reference.at(session.resolution(), deadline.stop());
  if (!prepared.map) {
    return stoppedBefore();
  }
  work::Stopwatch watch;
  const SearchSession search_session = searchSession(session, prepared.map->resolution(), options_);
  SearchResult result = begin(prepared, search_session, demand, constraints, deadline);
  result.search_time = watch.lap();
  result.reference_time = prepared.time;
  return result;
}

SearchResult MapMatcher::matchFrom(const SearchResult& start, const Reference& reference,
                                   const grid::OccupancyGrid& session, const Demand& demand,
                                   const Constraints& constraints, const work::Deadline& deadline) const {
  requireExact("to search on from a glance");
  const Reference::Prepared prepared = reference.at(session.resolution(), deadline.stop());
  if (!prepared.map) {
    return stoppedBefore();
  }
  work::Stopwatch watch;
  const SearchSession search_session = searchSession(session, prepared.map->resolution(), options_);
  SearchResult result = certify(start, *prepared.map, search_session, options_, demand, constraints, deadline);
  result.search_time = start.search_time + watch.lap();
  result.reference_time = start.reference_time + prepared.time;
  return result;
}

void MapMatcher::requireExact(const char* what) const {
  if (options_.search != "exact") {
    throw std::invalid_argument("search is " + options_.search + ", expected exact " + what);
  }
}

SearchResult MapMatcher::follow(const Reference& reference, const grid::OccupancyGrid& session,
                                const grid::Rigid2& T_reference_session, const Demand& demand,
                                const work::StopToken& stop) const {
  requireExact("to follow a place");
  const Reference::Prepared prepared = reference.at(session.resolution(), stop);
  if (!prepared.map) {
    return stoppedBefore();
  }
  work::Stopwatch watch;
  const SearchSession search_session = searchSession(session, prepared.map->resolution(), options_);
  const work::Deadline deadline(options_.exact_deadline, stop);
  SearchResult result = followPlace(*prepared.map, search_session, options_, T_reference_session, demand, deadline);
  result.search_time = watch.lap();
  result.reference_time = prepared.time;
  return result;
}

}  // namespace map_matcher::search
