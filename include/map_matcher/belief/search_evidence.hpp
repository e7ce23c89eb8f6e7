/// \file
/// What a search says for and against the place that it found.
#pragma once

#include "map_matcher/belief/evidence.hpp"
#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/search/search_result.hpp"

namespace map_matcher::belief {

/// "ratio", of a search without proof: the share of session cells on walls, held against the acceptance ratio of the
/// stage that answered. Against the place (kBelowAcceptanceRatio, or kNotCertified when the time was over) when none
/// was found.
Evidence ratioEvidence(const search::SearchResult& result, const MatchOptions& options);

/// "proof": by how much the hit ratio of a pose not found may exceed that of the place; 0 when certified. Against it
/// (kNotCertified) unless it is certified.
Evidence proofEvidence(const search::SearchResult& result, const MatchOptions& options);

/// "hit_ratio", held against min_hit_ratio. Against the place (kBelowAcceptanceRatio) when there is none, proven.
Evidence hitEvidence(const search::SearchResult& result, const MatchOptions& options);

/// "margin", by how much the place is worth more than the best place elsewhere, held against min_margin. For the place
/// as well when the search for others did not come to its end, but none of them, found or not, can be too near. Against
/// it when a place elsewhere is too near (kAmbiguous), or none is known to be but that is not proven
/// (kNotCertified); silent instead where the place is that of an earlier map (`follows`).
Evidence marginEvidence(const Findings& findings, const MatchOptions& options, bool follows);

}  // namespace map_matcher::belief
