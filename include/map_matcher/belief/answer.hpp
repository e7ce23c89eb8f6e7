/// \file
/// What is to be made of a session map, and why.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/belief/evidence.hpp"
#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/match_status.hpp"
#include "map_matcher/belief/surroundings.hpp"
#include "map_matcher/search/search_result.hpp"

namespace map_matcher::belief {

/// A search's result, judged.
struct Answer {
  MatchStatus status = MatchStatus::kNoReference;
  std::string reason;              ///< One sentence with the figures behind the status.
  std::vector<Evidence> evidence;  ///< All that was looked at, in the order in which it decides.
  search::SearchResult search;     ///< What was found; its pose is to be relied on when matched. See Findings::search.
  std::size_t map = 0;             ///< The number of the reference map that it is in.
  double probability = 0.0;        ///< That the place is right; of an exact search.
  std::vector<Candidate> candidates;  ///< The places that were found, the one worth most first; of an exact search.
  Surroundings nearby;                ///< Of the robot; without cells where its place is not known.

  bool matched() const { return status == MatchStatus::kMatched; }

  /// T_reference_session, to be relied on; nothing unless matched.
  std::optional<grid::Rigid2> alignment() const {
    return matched() ? std::optional<grid::Rigid2>(search.T_reference_session) : std::nullopt;
  }
};

}  // namespace map_matcher::belief
