/// \file
/// What the walls and the free space of both maps say for and against a place.
#pragma once

#include <vector>

#include "map_matcher/belief/evidence.hpp"
#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/match_options.hpp"

namespace map_matcher::belief {

/// "seen_through", the share of the reference map's walls that lie in free space of the session map: for the place
/// where they are few, else silent, since an open door is one, too; "probability" weighs it. "in_the_open", the share
/// of the session's walls that lie in free space of the reference map: never more than told, since people and furniture
/// are. "agreeing_walls", FreeSpace::agreeing(): how much there is to judge by.
std::vector<Evidence> freeSpaceEvidence(const FreeSpace& space);

/// "probability" of the place to be right, held against min_probability. Against it (kDoubtful) when it is smaller, but
/// for a place that another map of the session found as well (`confirmed`), where tentative_probability is enough.
/// Silent where the place is that of an earlier map that was matched (`follows`).
Evidence probabilityEvidence(double probability, const BeliefOptions& options, bool confirmed, bool follows);

/// "followed": the place is that of an earlier map, and was looked at without a proof.
Evidence followedEvidence(const Findings& findings);

}  // namespace map_matcher::belief
