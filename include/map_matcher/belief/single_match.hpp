/// \file
/// One session map on its own.
#pragma once

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/place_search.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/constraints.hpp"
#include "map_matcher/work/deadline.hpp"
#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::belief {

/// Searches a session map and judges what was found, with nothing else known: no earlier maps, no place of the robot.
/// Throws std::invalid_argument that names every option out of range, and what search::Reference::at throws.
Answer matchAlone(const ReferenceMaps& maps, const grid::OccupancyGrid& session, const MatchOptions& options,
                  const search::Constraints& constraints = {}, const work::StopToken& stop = {});

/// The same with a deadline of the caller's in place of SearchOptions::exact_deadline.
Answer matchAlone(const ReferenceMaps& maps, const grid::OccupancyGrid& session, const MatchOptions& options,
                  const search::Constraints& constraints, const work::Deadline& deadline);

}  // namespace map_matcher::belief
