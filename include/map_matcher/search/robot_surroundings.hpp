/// \file
/// Whether the session map fits where the robot is, and not only where it was.
#pragma once

#include <Eigen/Core>

#include "map_matcher/search/match_prior.hpp"
#include "map_matcher/search/match_result.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_session.hpp"

namespace map_matcher {

/// Session cells around the robot that are enough to judge by [cells].
constexpr int kFewestNearbyCells = 30;

/// The session cells up to options.nearby_distance from `robot` [m, session map frame], with the map at
/// `T_reference_session`. `reference` is built for the exact search.
Surroundings surroundings(const SearchReference& reference, const SearchSession& session, const MatchOptions& options,
                          const Rigid2& T_reference_session, const Eigen::Vector2d& robot);

/// Takes back a match, with status kRobotAstray, when the map does not fit around prior.robot. A mapper that has lost
/// the robot goes on to draw walls where there are none: the older part of its map matches as before, and the
/// alignment is right, but the robot is not where tf puts it. After such an answer (prior.robot_astray) the share of
/// hits has to be half-way between options.min_nearby_ratio and 1. Fewer than kFewestNearbyCells decide nothing: what
/// was said of the map before stands. What is no match stays as it is, as does any match without prior.robot or with
/// options.min_nearby_ratio = 0. `result` has an answer of an exact search in it.
void checkRobot(MatchResult& result, const SearchReference& reference, const SearchSession& session,
                const MatchOptions& options, const MatchPrior& prior);

}  // namespace map_matcher
