#include "map_matcher/belief/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/search/matched_cells.hpp"

namespace map_matcher::belief {
namespace {

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

/// The two maps, one on the other.
struct Overlay {
  const search::SearchReference& reference;
  const grid::OccupancyGrid& session;
  grid::Rigid2 T_session_cells;  ///< Pose of the session grid's corner, with session_map_cell_offset.
  grid::Rigid2 T_grid_session;   ///< Into the searched reference grid.
};

/// Adds to `nearby` the share of the session cells around the robot that are hits.
void countHits(const Overlay& maps, const Eigen::Vector2d& robot, const MatchOptions& options, Surroundings& nearby) {
  int hits = 0;
  const double resolution = maps.session.resolution();
  for (const grid::Cell& cell :
       grid::occupiedCells(maps.session, static_cast<std::int8_t>(options.search.occupied_threshold))) {
    const Eigen::Vector2d p_session = maps.T_session_cells * (Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5) * resolution);
    if ((p_session - robot).norm() <= options.belief.nearby_distance) {
      const search::WidenedGrids& hits_of = maps.reference.exact();
      const grid::Cell position =
          hits_of.position(0, grid::cellOf(maps.T_grid_session * p_session, maps.reference.resolution()));
      hits += hits_of.level(0).at(position.x, position.y);
      ++nearby.cells;
    }
  }
  nearby.cells_length = nearby.cells * resolution;
  nearby.ratio = nearby.cells > 0 ? static_cast<double>(hits) / nearby.cells : 0.0;
}

/// Adds to `nearby` the share of the reference map's wall cells around the robot that the session map has as well.
void countWalls(const Overlay& maps, const Eigen::Vector2d& robot, const MatchOptions& options, Surroundings& nearby) {
  const search::PrecomputedGrids& grids = maps.reference.fine();
  const double resolution = maps.reference.resolution();
  const double distance = options.belief.nearby_distance;
  const Eigen::Vector2d middle = maps.T_grid_session * robot;
  const grid::Rigid2 T_cells_grid = maps.T_session_cells.inverse() * maps.T_grid_session.inverse();
  const int reach = static_cast<int>(std::lround(kSameWall / maps.session.resolution()));
  const grid::Cell low = grid::cellOf(middle - Eigen::Vector2d::Constant(distance), resolution);
  const grid::Cell high = grid::cellOf(middle + Eigen::Vector2d::Constant(distance), resolution);
  const grid::Cell first{std::max(low.x, grids.firstWall().x), std::max(low.y, grids.firstWall().y)};
  const grid::Cell last{std::min(high.x, grids.lastWall().x), std::min(high.y, grids.lastWall().y)};
  int confirmed = 0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      const Eigen::Vector2d centre = Eigen::Vector2d(x + 0.5, y + 0.5) * resolution;
      if (grids.level(0).at(x, y) == 0 || (centre - middle).norm() > distance) {
        continue;
      }
      const grid::Cell cell = grid::cellOf(T_cells_grid * centre, maps.session.resolution());
      if (maps.session.geometry().contains(cell) && maps.session.at(cell.x, cell.y) >= 0) {
        confirmed += isWallWithin(maps.session, cell, reach, options.search.occupied_threshold) ? 1 : 0;
        ++nearby.walls;
      }
    }
  }
  nearby.walls_length = nearby.walls * resolution;
  nearby.walls_ratio = nearby.walls > 0 ? static_cast<double>(confirmed) / nearby.walls : 0.0;
}

std::string lostText(const Surroundings& nearby, const BeliefOptions& options) {
  std::ostringstream text;
  text << "the session map fits, but not where the robot is: up to " << options.nearby_distance << " m from it, "
       << nearby.ratio << " of " << nearby.cells << " session cells lie near walls, and " << nearby.walls_ratio
       << " of " << nearby.walls
       << " wall cells of the reference map are in the session map (min_nearby_ratio = " << options.min_nearby_ratio
       << ", min_nearby_walls = " << options.min_nearby_walls
       << "). The mapper has lost the robot in its map, or the reference map is out of date there";
  return text.str();
}

bool isEnough(const Surroundings& nearby) { return std::min(nearby.cells_length, nearby.walls_length) >= kEnoughWalls; }

}  // namespace

Surroundings surroundings(const search::Reference& reference, const grid::OccupancyGrid& session,
                          const MatchOptions& options, const grid::Rigid2& T_reference_session,
                          const Eigen::Vector2d& robot) {
  const search::Reference::Prepared prepared = reference.at(session.resolution());
  const Overlay maps{*prepared.map, session, grid::cornerOf(session.geometry(), options.search.session_map_cell_offset),
                     prepared.map->T_reference_grid().inverse() * T_reference_session};
  Surroundings nearby;
  countHits(maps, robot, options, nearby);
  countWalls(maps, robot, options, nearby);
  return nearby;
}

bool isLost(const Surroundings& nearby, const BeliefOptions& options, bool was_lost) {
  if (!isEnough(nearby)) {
    return was_lost;
  }
  const bool cells_fit = nearby.ratio >= options.min_nearby_ratio;
  const bool walls_fit = nearby.walls_ratio >= options.min_nearby_walls;
  return was_lost ? !(cells_fit && walls_fit) : !(cells_fit || walls_fit);
}

std::vector<Evidence> surroundingsEvidence(const Surroundings& nearby, const BeliefOptions& options, bool was_lost) {
  Evidence cells{"nearby_ratio", nearby.ratio, options.min_nearby_ratio, Bearing::kSilent, MatchStatus::kRobotLost, {}};
  Evidence walls{"nearby_walls_ratio", nearby.walls_ratio,      options.min_nearby_walls,
                 Bearing::kSilent,     MatchStatus::kRobotLost, {}};
  if (isLost(nearby, options, was_lost)) {
    cells.bearing = walls.bearing = Bearing::kAgainst;
    cells.text = walls.text = lostText(nearby, options);
  } else if (isEnough(nearby)) {
    cells.bearing = walls.bearing = Bearing::kFor;
    cells.text = walls.text = "the session map fits around the robot";
  } else {
    cells.text = walls.text = "too little is to be seen around the robot";
  }
  return {cells, walls};
}

}  // namespace map_matcher::belief
