/// \file
/// Whether the session map fits where the robot is, and not only where it was.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "map_matcher/belief/evidence.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/reference.hpp"

namespace map_matcher::belief {

/// How far apart, along each axis, walls of the two maps may be to be the same: what mappers bend [m].
constexpr double kSameWall = 0.25;

/// Length of walls around the robot, one cell thick, that is enough to judge by [m].
constexpr double kEnoughWalls = 3.0;

/// How the two maps agree around the robot.
struct Surroundings {
  int cells = 0;              ///< Session cells there [cells].
  double cells_length = 0.0;  ///< The length of wall that they make, one cell thick [m].
  double ratio = 0.0;         ///< Share of them within hit_tolerance of a wall of the reference map.
  int walls = 0;              ///< Wall cells of the reference map there at which the session map is known [cells].
  double walls_length = 0.0;  ///< The length of wall that they make, one cell thick [m].
  double walls_ratio = 0.0;   ///< Share of them at which the session map has a wall, too.
};

/// How the maps agree up to belief.nearby_distance from `robot` [m, session map frame], with `session` at
/// `T_reference_session`.
Surroundings surroundings(const search::Reference& reference, const grid::OccupancyGrid& session,
                          const MatchOptions& options, const grid::Rigid2& T_reference_session,
                          const Eigen::Vector2d& robot);

/// Whether the robot is not where it seems to be. A mapper that has lost the robot draws walls where there are none,
/// and free space where there are walls; people and moved furniture only do the one, so that both shares have to fall
/// below min_nearby_ratio and min_nearby_walls. After such an answer (`was_lost`) both have to reach these. Less of
/// either kind than kEnoughWalls decides nothing: what was said before stands.
bool isLost(const Surroundings& nearby, const BeliefOptions& options, bool was_lost);

/// The two shares, "nearby_ratio" and "nearby_walls_ratio": both against the place (kRobotLost), both for it, or silent
/// where too little is to be seen.
std::vector<Evidence> surroundingsEvidence(const Surroundings& nearby, const BeliefOptions& options, bool was_lost);

}  // namespace map_matcher::belief
