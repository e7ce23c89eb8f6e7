/// \file
/// Where an exact search begins.
#pragma once

#include <cstdint>

#include "block_search.hpp"
#include "map_matcher/search/exact/exact_search.hpp"

namespace map_matcher::search {

/// The levels that promise the least work, from samples of a few blocks of rotations, at most the reference's top
/// level. Wide nodes are few, but in a building many of them reach `min_count` and have to be searched below; most of a
/// large map is empty, and wide nodes pass over that quickly. The levels do not change the answer. Work is counted in
/// cells, so that the choice is the same on every run.
RootLevels cheapestRootLevels(const ExactProblem& problem, const ExactSettings& settings, std::int32_t min_count);

}  // namespace map_matcher::search
