/// \file
/// What a search is to find out.
#pragma once

namespace map_matcher::search {

/// What the caller wants to know for sure; it decides how far an exact search looks.
struct Demand {
  double min_hit_ratio = 0.6;  ///< Places with a smaller share of hits need not be found, 0 to 1.
  double margin = 0.1;         ///< Nor do places elsewhere whose share is farther below the best, 0 to 1.
};

}  // namespace map_matcher::search
