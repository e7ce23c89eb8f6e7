/// \file
/// Which places are believed.
#pragma once

#include <optional>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/surroundings.hpp"
#include "map_matcher/search/search_result.hpp"

namespace map_matcher::belief {

/// What is known beside the search; nothing needs to be.
struct Circumstances {
  std::optional<grid::Rigid2> alignment;  ///< T_reference_session of an earlier map of the session that was matched.
  std::optional<grid::Rigid2> contender;  ///< That of the map before, which was at odds with `alignment`: a place that
                                          ///< agrees with it is confirmed.
  std::optional<Surroundings> nearby;     ///< How the maps agree around the robot, where tf knows its place.
  bool robot_was_lost = false;            ///< Whether that was the answer for the last map of the session that fitted.
};

/// Gathers the evidence and lets the first piece that speaks against the place decide: the proof, the hits, the margin
/// to the best place elsewhere, what earlier maps said, the surroundings of the robot. Without one, the place is
/// matched. A wrong pose that looks right is worse than none: what is not proven is not accepted. The answer of a
/// search without proof (SearchOptions::search "two_stage") is taken as it is.
Answer judge(const search::SearchResult& result, const MatchOptions& options, const Circumstances& circumstances = {});

}  // namespace map_matcher::belief
