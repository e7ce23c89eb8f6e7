#include "map_matcher/search/robot_surroundings.hpp"

#include <cmath>
#include <sstream>

namespace map_matcher {
namespace {

Cell cellOf(const Eigen::Vector2d& p_grid, double resolution) {
  return {static_cast<int>(std::floor(p_grid.x() / resolution)), static_cast<int>(std::floor(p_grid.y() / resolution))};
}

/// Smallest share of hits around the robot that is believed: a robot that was lost has to be clearly found again.
double neededRatio(const MatchOptions& options, bool robot_astray) {
  return robot_astray ? 0.5 * (options.min_nearby_ratio + 1.0) : options.min_nearby_ratio;
}

std::string astrayReason(const Surroundings& nearby, const MatchOptions& options, double needed) {
  std::ostringstream reason;
  reason << "the session map fits, but not where the robot is: up to " << options.nearby_distance << " m from it "
         << nearby.hits << " of " << nearby.cells << " session cells lie near walls, a ratio of " << nearby.ratio()
         << "; expected " << needed << " (min_nearby_ratio = " << options.min_nearby_ratio << ") of at least "
         << kFewestNearbyCells << " cells. The mapper has lost the robot in its map, or the reference map does not "
         << "know what is there";
  return reason.str();
}

}  // namespace

Surroundings surroundings(const SearchReference& reference, const SearchSession& session, const MatchOptions& options,
                          const Rigid2& T_reference_session, const Eigen::Vector2d& robot) {
  const Rigid2 T_grid_session = reference.T_reference_grid().inverse() * T_reference_session;
  Surroundings nearby;
  for (const Cell& cell : session.cells) {
    const Eigen::Vector2d centre = Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5) * session.resolution;
    const Eigen::Vector2d p_session = session.T_session_grid * centre;
    if ((p_session - robot).norm() > options.nearby_distance) {
      continue;
    }
    const Cell position = reference.exact().position(0, cellOf(T_grid_session * p_session, reference.resolution()));
    ++nearby.cells;
    nearby.hits += reference.exact().level(0).at(position.x, position.y);
  }
  return nearby;
}

void checkRobot(MatchResult& result, const SearchReference& reference, const SearchSession& session,
                const MatchOptions& options, const MatchPrior& prior) {
  if (!result.matched() || !prior.robot || options.min_nearby_ratio <= 0.0) {
    return;
  }
  result.nearby = surroundings(reference, session, options, result.T_reference_session, *prior.robot);
  const bool decides = result.nearby.cells >= kFewestNearbyCells;
  const double needed = neededRatio(options, prior.robot_astray);
  if (decides ? result.nearby.ratio() < needed : prior.robot_astray) {
    result.status = MatchStatus::kRobotAstray;
    result.reason = astrayReason(result.nearby, options, needed);
    result.covariance.setZero();
  }
}

}  // namespace map_matcher
