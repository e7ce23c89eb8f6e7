/// \file
/// The facade of the search: set a reference map, match session maps to it.
#pragma once

#include <memory>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/deadline.hpp"
#include "map_matcher/search/match_options.hpp"
#include "map_matcher/search/match_prior.hpp"
#include "map_matcher/search/match_result.hpp"
#include "map_matcher/search/stop_token.hpp"

namespace map_matcher {

class SearchReference;

/// Finds how a session map lies in a reference map (report section 3). Not thread-safe: one thread, the worker, uses
/// it; only the stop token may be set from others.
class MapMatcher {
 public:
  /// Throws std::invalid_argument that names every option out of range.
  explicit MapMatcher(const MatchOptions& options = {});
  ~MapMatcher();
  MapMatcher(MapMatcher&&) noexcept;
  MapMatcher& operator=(MapMatcher&&) noexcept;

  const MatchOptions& options() const { return options_; }

  /// Takes a reference map of any resolution and origin and builds what the search needs of it; that is built again
  /// only when session maps coarser than the reference arrive.
  void setReference(OccupancyGrid reference);

  bool hasReference() const { return reference_ != nullptr; }

  /// The pose of the session map in the reference map, or the reason why there is none. Both poses are those of the map
  /// frames, so that the grids' origins, with their yaws, are taken into account. Returns within 50 ms of a stop.
  MatchResult match(const OccupancyGrid& session, const MatchPrior& prior = {}, const StopToken& stop = {});

  /// The same with a deadline of the caller's in place of MatchOptions::exact_deadline.
  MatchResult match(const OccupancyGrid& session, const MatchPrior& prior, const Deadline& deadline);

 private:
  MatchOptions options_;
  std::shared_ptr<const OccupancyGrid> reference_;
  std::shared_ptr<const SearchReference> search_reference_;
  double reference_time_ = 0.0;  // of building search_reference_ [s]

  void buildSearchReference(double resolution);
};

}  // namespace map_matcher
