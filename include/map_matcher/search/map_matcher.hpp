/// \file
/// The facade of the search: set a reference map, match session maps to it.
#pragma once

#include <memory>
#include <optional>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/match_options.hpp"
#include "map_matcher/search/match_prior.hpp"
#include "map_matcher/search/match_result.hpp"
#include "map_matcher/work/deadline.hpp"
#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::search {

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
  /// only when session maps coarser than the reference arrive. When it is stopped, or throws, the reference map before
  /// stays in use. Whether it was not stopped. Throws std::invalid_argument for a map too large for the search, and
  /// std::system_error when no thread can be started.
  bool setReference(grid::OccupancyGrid reference, const work::StopToken& stop = {});

  bool hasReference() const { return reference_ != nullptr; }

  /// The pose of the session map in the reference map, or the reason why there is none. Both poses are those of the map
  /// frames, so that the grids' origins, with their yaws, are taken into account. Ends MatchOptions::exact_deadline
  /// after it began; building what is needed of the reference map does not count. Returns within 50 ms of a stop.
  MatchResult match(const grid::OccupancyGrid& session, const MatchPrior& prior = {}, const work::StopToken& stop = {});

  /// The same with a deadline of the caller's in place of MatchOptions::exact_deadline.
  MatchResult match(const grid::OccupancyGrid& session, const MatchPrior& prior, const work::Deadline& deadline);

 private:
  /// What is built of a reference map.
  struct Built {
    std::shared_ptr<const SearchReference> reference;  // nothing when it was stopped
    double time = 0.0;                                 // that it took [s]
  };

  Built build(const grid::OccupancyGrid& reference, double resolution, const work::StopToken& stop) const;
  std::optional<MatchResult> prepareFor(const grid::OccupancyGrid& session, const work::StopToken& stop);
  MatchResult search(const grid::OccupancyGrid& session, const MatchPrior& prior, const work::Deadline& deadline) const;

  MatchOptions options_;
  std::shared_ptr<const grid::OccupancyGrid> reference_;
  Built built_;  // of reference_
};

}  // namespace map_matcher::search
