/// \file
/// The session maps of a drive, one after the other, matched and judged as in the node.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/session_tracker.hpp"
#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/search/reference.hpp"
#include "map_matcher/trials/trial_query.hpp"

namespace map_matcher::trials {

/// Matches session maps to a reference map and keeps what came of it. Not thread-safe.
class SessionMatching {
 public:
  /// Throws std::invalid_argument that names every option out of range.
  SessionMatching(const grid::OccupancyGrid& reference, const belief::MatchOptions& options);

  /// A new session begins: its maps have another frame than those before.
  void beginSession() { tracker_.reset(); }

  /// The session's next map. `query` says how the map came to be; answer, occupied and falsely_occupied are filled in.
  void match(grid::OccupancyGrid map, TrialQuery query);

  /// Called once with the first session map that is matched and T_reference_session.
  using OnFirstMatch = std::function<void(const grid::OccupancyGrid&, const grid::Rigid2&)>;
  void onFirstMatch(OnFirstMatch on_first_match) { on_first_match_ = std::move(on_first_match); }

  const std::vector<TrialQuery>& queries() const { return queries_; }

  /// The last session map; nothing before the first one.
  const std::optional<grid::OccupancyGrid>& lastMap() const { return last_map_; }

 private:
  search::Reference reference_;
  search::MapMatcher matcher_;
  belief::SessionTracker tracker_;
  std::vector<TrialQuery> queries_;
  std::optional<grid::OccupancyGrid> last_map_;
  OnFirstMatch on_first_match_;  // null when it was called, or nobody asked
};

}  // namespace map_matcher::trials
