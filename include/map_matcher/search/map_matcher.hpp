/// \file
/// The facade of the search.
#pragma once

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/constraints.hpp"
#include "map_matcher/search/demand.hpp"
#include "map_matcher/search/reference.hpp"
#include "map_matcher/search/search_options.hpp"
#include "map_matcher/search/search_result.hpp"
#include "map_matcher/work/deadline.hpp"
#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::search {

struct SearchSession;

/// Finds how session maps lie in reference maps (report section 3). Never changes: several threads may search with it,
/// in one reference map or in several.
class MapMatcher {
 public:
  /// Throws std::invalid_argument that names every option out of range.
  explicit MapMatcher(const SearchOptions& options = {});

  const SearchOptions& options() const { return options_; }

  /// The best pose of the session map in the reference map, what is proven of it, and the best place elsewhere; or the
  /// reason why there is none. Poses are those of the map frames, so that the grids' origins, with their yaws, are
  /// taken into account. Ends SearchOptions::exact_deadline after it began; building what is needed of the reference
  /// map, if that was not done yet, does not count. Throws what Reference::at throws.
  SearchResult match(const Reference& reference, const grid::OccupancyGrid& session, const Demand& demand = {},
                     const Constraints& constraints = {}, const work::StopToken& stop = {}) const;

  /// The same with a deadline of the caller's in place of SearchOptions::exact_deadline.
  SearchResult match(const Reference& reference, const grid::OccupancyGrid& session, const Demand& demand,
                     const Constraints& constraints, const work::Deadline& deadline) const;

  /// What the two stages find of it with little effort: where an exact search begins, and of several reference maps a
  /// hint which to search first. Not found says nothing. Throws what Reference::at throws.
  SearchResult glance(const Reference& reference, const grid::OccupancyGrid& session, const Demand& demand,
                      const Constraints& constraints, const work::Deadline& deadline) const;

  /// The exact search from there: match() with the same arguments, but for a demand that may be stricter. Throws
  /// std::invalid_argument unless options.search is "exact", and what Reference::at throws.
  SearchResult matchFrom(const SearchResult& start, const Reference& reference, const grid::OccupancyGrid& session,
                         const Demand& demand, const Constraints& constraints, const work::Deadline& deadline) const;

  /// The place that a session map lies at when it is known to lie near `T_reference_session`, as after an earlier
  /// session map of the same drive: the best pose uphill from there, by hits, moved to where it fits best, in a few
  /// milliseconds. Nothing is proven and nothing said of places elsewhere: `places` has that one, certified is false
  /// and elsewhere_bound 1. Found is false when fewer than demand.min_hit_ratio of the cells are hits there. Throws
  /// std::invalid_argument unless options.search is "exact", and what Reference::at throws.
  SearchResult follow(const Reference& reference, const grid::OccupancyGrid& session,
                      const grid::Rigid2& T_reference_session, const Demand& demand,
                      const work::StopToken& stop = {}) const;

 private:
  SearchResult search(const Reference::Prepared& prepared, const grid::OccupancyGrid& session, const Demand& demand,
                      const Constraints& constraints, const work::Deadline& deadline) const;
  SearchResult begin(const Reference::Prepared& prepared, const SearchSession& session, const Demand& demand,
                     const Constraints& constraints, const work::Deadline& deadline) const;
  void requireExact(const char* what) const;

  SearchOptions options_;
};

}  // namespace map_matcher::search
