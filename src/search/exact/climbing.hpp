/// \file
/// From a pose to the best one near it.
#pragma once

#include <optional>

#include "map_matcher/search/exact/exact_search.hpp"
#include "map_matcher/search/search_frames.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// The best of the poses that lie uphill from one [of the session's centre], step by step. Nothing when the problem
/// allows no pose around it that has a hit, or the deadline passed at once. Of the problem, the reference, rotations
/// and windows count.
std::optional<SearchPose> climbFrom(const CentrePose& pose, double resolution, const ExactProblem& problem,
                                    const work::Deadline& deadline);

}  // namespace map_matcher::search
