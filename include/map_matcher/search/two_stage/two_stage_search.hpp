/// \file
/// The report's two-stage search (sections 3.1 and 3.2).
#pragma once

#include <cstdint>
#include <optional>

#include "map_matcher/search/constraints.hpp"
#include "map_matcher/search/search_options.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_result.hpp"
#include "map_matcher/search/search_session.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// What one cell and one angular step of the coarse stage can hide from the fine stage.
struct FineWindow {
  int half_width = 0;                ///< Translations to look at on either side of the coarse answer [fine cells].
  double rotation_half_width = 0.0;  ///< Rotations to look at on either side of the coarse answer [rad].
};

/// The window of the fine stage around the coarse answer. A session cell on its wall at the true pose is found in the
/// coarse stage at a translation that differs along an axis by less than
///   1 coarse cell           for where the wall lies within its coarse cell,
///   sqrt(2) / 2             for where the session cell lies within its own, turned, coarse cell, and
///   rotation_downsampling/2 for the way that the farthest session cell goes in one coarse angular step (eq. 4.2),
/// all times `cells_per_coarse_cell`; and the true rotation lies within one coarse angular step.
FineWindow fineWindow(double cells_per_coarse_cell, double coarse_rotation_downsampling, double coarse_rotation_step);

/// Coarse stage over all rotations and all translations, then fine stage around its answer. Fills everything of the
/// result but the times of the whole match and what the exact search adds. Returns within 50 ms of a stop. Where the
/// answer is only a start for the exact search, the coarse stage may give up after `most_expansions` nodes: those of
/// the right place come among the first.
SearchResult twoStageSearch(const SearchReference& reference, const SearchSession& session,
                            const SearchOptions& options, const Constraints& constraints,
                            const work::Deadline& deadline, std::optional<std::int64_t> most_expansions = std::nullopt);

}  // namespace map_matcher::search
