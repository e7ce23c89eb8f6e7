#include "map_matcher/search/robot_surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace map_matcher::search {
namespace {

grid::Cell cellOf(const Eigen::Vector2d& p_grid, double resolution) {
  return {static_cast<int>(std::floor(p_grid.x() / resolution)), static_cast<int>(std::floor(p_grid.y() / resolution))};
}

bool isWallWithin(const grid::OccupancyGrid& map, const grid::Cell& cell, int reach, int occupied_threshold) {
  const grid::Cell first{std::max(0, cell.x - reach), std::max(0, cell.y - reach)};
  const grid::Cell last{std::min(map.width() - 1, cell.x + reach), std::min(map.height() - 1, cell.y + reach)};
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      if (map.at(x, y) >= occupied_threshold) {
        return true;
      }
    }
  }
  return false;
}

/// Adds to `nearby` the share of the session cells around the robot that are hits.
void countHits(const SearchReference& reference, const SearchSession& session, const grid::Rigid2& T_grid_session,
               const Eigen::Vector2d& robot, double distance, Surroundings& nearby) {
  int hits = 0;
  for (const grid::Cell& cell : session.cells) {
    const Eigen::Vector2d centre = Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5) * session.resolution;
    const Eigen::Vector2d p_session = session.T_session_grid * centre;
    if ((p_session - robot).norm() <= distance) {
      const grid::Cell position =
          reference.exact().position(0, cellOf(T_grid_session * p_session, reference.resolution()));
      hits += reference.exact().level(0).at(position.x, position.y);
      ++nearby.cells;
    }
  }
  nearby.ratio = nearby.cells > 0 ? static_cast<double>(hits) / nearby.cells : 0.0;
}

/// Adds to `nearby` the share of the reference map's wall cells up to `distance` from `middle` [m, grid] that the
/// session map, of which `T_cells_grid` finds the cells, has as well.
void countWalls(const SearchReference& reference, const grid::OccupancyGrid& session, const grid::Rigid2& T_cells_grid,
                const Eigen::Vector2d& middle, const MatchOptions& options, Surroundings& nearby) {
  const PrecomputedGrids& grids = reference.fine();
  const double resolution = reference.resolution();
  const int reach = static_cast<int>(std::lround(kSameWall / session.resolution()));
  const Eigen::Vector2d half_size = Eigen::Vector2d::Constant(options.nearby_distance);
  const grid::Cell low = cellOf(middle - half_size, resolution);
  const grid::Cell high = cellOf(middle + half_size, resolution);
  const grid::Cell first{std::max(low.x, grids.firstWall().x), std::max(low.y, grids.firstWall().y)};
  const grid::Cell last{std::min(high.x, grids.lastWall().x), std::min(high.y, grids.lastWall().y)};
  int confirmed = 0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      const Eigen::Vector2d centre = Eigen::Vector2d(x + 0.5, y + 0.5) * resolution;
      if (grids.level(0).at(x, y) == 0 || (centre - middle).norm() > options.nearby_distance) {
        continue;
      }
      const grid::Cell cell = cellOf(T_cells_grid * centre, session.resolution());
      if (session.geometry().contains(cell) && session.at(cell.x, cell.y) >= 0) {
        confirmed += isWallWithin(session, cell, reach, options.occupied_threshold) ? 1 : 0;
        ++nearby.walls;
      }
    }
  }
  nearby.walls_ratio = nearby.walls > 0 ? static_cast<double>(confirmed) / nearby.walls : 0.0;
}

std::string astrayReason(const Surroundings& nearby, const MatchOptions& options) {
  std::ostringstream reason;
  reason << "the session map fits, but not where the robot is: up to " << options.nearby_distance << " m from it, "
         << nearby.ratio << " of " << nearby.cells << " session cells lie near walls, and " << nearby.walls_ratio
         << " of " << nearby.walls
         << " wall cells of the reference map are in the session map (min_nearby_ratio = " << options.min_nearby_ratio
         << ", min_nearby_walls = " << options.min_nearby_walls
         << "). The mapper has lost the robot in its map, or the reference map is out of date there";
  return reason.str();
}

}  // namespace

Surroundings surroundings(const SearchReference& reference, const grid::OccupancyGrid& session,
                          const SearchSession& search_session, const MatchOptions& options,
                          const grid::Rigid2& T_reference_session, const Eigen::Vector2d& robot) {
  const grid::Rigid2 T_grid_session = reference.T_reference_grid().inverse() * T_reference_session;
  const grid::Rigid2 T_cells_grid = search_session.T_session_grid.inverse() * T_grid_session.inverse();
  Surroundings nearby;
  countHits(reference, search_session, T_grid_session, robot, options.nearby_distance, nearby);
  countWalls(reference, session, T_cells_grid, T_grid_session * robot, options, nearby);
  return nearby;
}

bool isAstray(const Surroundings& nearby, double resolution, const MatchOptions& options, bool was_astray) {
  if (std::min(nearby.cells, nearby.walls) * resolution < kEnoughWalls) {
    return was_astray;
  }
  const bool cells_fit = nearby.ratio >= options.min_nearby_ratio;
  const bool walls_fit = nearby.walls_ratio >= options.min_nearby_walls;
  return was_astray ? !(cells_fit && walls_fit) : !(cells_fit || walls_fit);
}

void checkRobot(MatchResult& result, const SearchReference& reference, const grid::OccupancyGrid& session,
                const SearchSession& search_session, const MatchOptions& options, const MatchPrior& prior) {
  if (!result.matched() || !prior.robot) {
    return;
  }
  result.nearby = surroundings(reference, session, search_session, options, result.T_reference_session, *prior.robot);
  if (isAstray(result.nearby, session.resolution(), options, prior.robot_astray)) {
    result.status = MatchStatus::kRobotAstray;
    result.reason = astrayReason(result.nearby, options);
    result.covariance.setZero();
  }
}

}  // namespace map_matcher::search
