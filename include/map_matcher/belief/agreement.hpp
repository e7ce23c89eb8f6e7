/// \file
/// What earlier maps of the session say about a place.
#pragma once

#include <optional>

#include "map_matcher/belief/evidence.hpp"
#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/known_place.hpp"
#include "map_matcher/belief/match_options.hpp"

namespace map_matcher::belief {

/// How a place stands to those that earlier maps of the session were found at.
enum class Standing {
  kFirst,        ///< None of them was matched.
  kAgrees,       ///< It is the place of the last one that was matched.
  kConfirms,     ///< It is another one, but that of the map before, the contender.
  kContradicts,  ///< It is neither.
};

/// `alignment` and `contender` as in Circumstances. Two poses are of one place up to distinct_distance and
/// distinct_angle, in one reference map.
Standing standingOf(const Findings& findings, const search::SearchOptions& options,
                    const std::optional<KnownPlace>& alignment, const std::optional<KnownPlace>& contender);

/// Whether the place that was found is that one.
bool isSamePlace(const Findings& findings, const search::SearchOptions& options, const KnownPlace& place);

/// Whether a candidate is that place.
bool isAt(const Candidate& candidate, const Eigen::Vector2d& session_centre, const KnownPlace& place,
          const search::SearchOptions& options);

/// "agreement": the distance [m] from the place of an earlier map. Against the place (kUnconfirmed) when it contradicts
/// and options.belief.confirm_relocation is set.
Evidence agreementEvidence(const Findings& findings, const MatchOptions& options, Standing standing,
                           const std::optional<KnownPlace>& alignment);

}  // namespace map_matcher::belief
