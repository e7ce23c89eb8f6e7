/// \file
/// Which places are believed.
#pragma once

#include <optional>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/known_place.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/surroundings.hpp"

namespace map_matcher::belief {

/// What is known beside the search; nothing needs to be.
struct Circumstances {
  std::optional<KnownPlace> alignment;  ///< The place of an earlier map of the session that was matched.
  std::optional<KnownPlace> contender;  ///< That of the map before, which was at odds with `alignment`: a place that
                                        ///< agrees with it is confirmed.
  std::optional<KnownPlace> tentative;  ///< That of an earlier map, none being matched, at which probability was
                                        ///< wanting: a place that agrees with it needs less.
  std::optional<Surroundings> nearby;   ///< How the maps agree around the robot, where tf knows its place.
  std::optional<Evidence> prior;        ///< What somebody says of it, as priorEvidence() has it.
  double probability = 0.0;             ///< Of `alignment` being right, when it was last proven.
  bool robot_was_lost = false;          ///< Whether that was the answer for the last map of the session that fitted.
};

/// Gathers the evidence and lets the first piece that speaks against the place decide: the proof, the hits, the margin
/// to the best place elsewhere, the probability that is made of these and of the free space, what earlier maps said,
/// the surroundings of the robot. Without one, the place is matched. A wrong pose that looks right is worse than none:
/// what is not proven is not accepted, but a place that was proven before and is followed. The answer of a search
/// without proof (SearchOptions::search "two_stage") is taken as it is.
Answer judge(const Findings& findings, const MatchOptions& options, const Circumstances& circumstances = {});

}  // namespace map_matcher::belief
