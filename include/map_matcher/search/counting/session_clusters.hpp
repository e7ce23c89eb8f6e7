/// \file
/// Session cells put together for the high levels of the exact search.
#pragma once

#include <cstdint>
#include <vector>

#include "map_matcher/search/counting/block_shape.hpp"
#include "map_matcher/search/counting/session_cells.hpp"
#include "map_matcher/search/counting/weighted_cells.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// Clusters of session cells, one point for all cells of each. They are made once for all rotations.
struct SessionClusters {
  std::vector<float> x;  ///< Middle, from the session's centre [cells], the largest first; where few have as many
                         ///< cells, once for each binary digit of their number.
  std::vector<float> y;  ///< The same.
  std::vector<WeightedCells::Run> runs;  ///< Of all points, in their order.
  std::int32_t total = 0;                ///< Session cells.
};

/// The largest clusters whose cells all lie in the window of their middle at each rotation of a node of a level, by
/// halving clusters that are too large. Cells near the session's centre move less when it turns, so that clusters are
/// larger there. A rotation step moves the farthest cell by half a cell at most. Throws DeadlinePassed when that comes
/// before the end.
SessionClusters clustersOf(const SessionCells& session, const BlockShape& shape,
                           const work::Deadline& deadline = work::Deadline());

}  // namespace map_matcher::search
