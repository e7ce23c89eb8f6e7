/// \file
/// What the maps of a session have said so far.
#pragma once

#include "map_matcher/search/match_prior.hpp"
#include "map_matcher/search/match_result.hpp"

namespace map_matcher::belief {

/// Keeps the alignment of the last accepted map, the place of one that was at odds with it, and whether the robot was
/// lost. Not thread-safe.
class SessionMemory {
 public:
  /// What the session's next map is matched with.
  const search::MatchPrior& prior() const { return prior_; }

  /// The answer for a map of the session, in their order. An accepted one is the alignment from now on, an unconfirmed
  /// one its contender, which any other answer of a search gives up.
  void add(const search::MatchResult& result);

  /// A new session begins: its maps have another frame than those before.
  void clear() { prior_ = {}; }

 private:
  search::MatchPrior prior_;
};

}  // namespace map_matcher::belief
