/// \file
/// What cannot be searched at all.
#pragma once

#include <optional>

#include "map_matcher/search/search_options.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_result.hpp"
#include "map_matcher/search/search_session.hpp"

namespace map_matcher::search {

/// The answer when the reference map has no walls, or the session map too few or too far apart ones; else nothing.
std::optional<SearchResult> checkInput(const SearchReference& reference, const SearchSession& session,
                                       const SearchOptions& options);

}  // namespace map_matcher::search
