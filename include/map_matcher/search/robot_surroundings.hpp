/// \file
/// Whether the session map fits where the robot is, and not only where it was.
#pragma once

#include <Eigen/Core>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/match_prior.hpp"
#include "map_matcher/search/match_result.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_session.hpp"

namespace map_matcher::search {

/// How far apart, along each axis, walls of the two maps may be to be the same: what mappers bend [m].
constexpr double kSameWall = 0.25;

/// Length of walls around the robot, one cell thick, that is enough to judge by [m].
constexpr double kEnoughWalls = 3.0;

/// How the maps agree up to options.nearby_distance from `robot` [m, session map frame], with `session`, of which
/// `search_session` was made, at `T_reference_session`. `reference` is built for the exact search.
Surroundings surroundings(const SearchReference& reference, const grid::OccupancyGrid& session,
                          const SearchSession& search_session, const MatchOptions& options,
                          const grid::Rigid2& T_reference_session, const Eigen::Vector2d& robot);

/// Whether the robot is not where it seems to be. A mapper that has lost the robot draws walls where there are none,
/// and free space where there are walls; people and moved furniture only do the one, so that both shares have to fall
/// below options.min_nearby_ratio and options.min_nearby_walls. After such an answer (`was_astray`) both have to reach
/// these. Fewer cells of either kind than kEnoughWalls takes at `resolution` [m] decide nothing: what was said before
/// stands.
bool isAstray(const Surroundings& nearby, double resolution, const MatchOptions& options, bool was_astray);

/// Takes back a match, with status kRobotAstray, when prior.robot is astray: the older part of the session map matches
/// as before, and the alignment is right, but the robot is not where tf puts it. What is no match stays as it is, as
/// does any match without prior.robot. `result` has an answer of an exact search in it.
void checkRobot(MatchResult& result, const SearchReference& reference, const grid::OccupancyGrid& session,
                const SearchSession& search_session, const MatchOptions& options, const MatchPrior& prior);

}  // namespace map_matcher::search
