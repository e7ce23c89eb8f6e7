#include "map_matcher/simulation/office_building.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "map_matcher/simulation/floor_plan.hpp"
#include "map_matcher/simulation/furnishing.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kMargin = 0.5;  // [m] of unknown cells around the building

/// Cells [first, last) along both axes.
struct CellRange {
  grid::Cell first;
  grid::Cell last;
};

/// Draws a floor plan into a grid. Lines of the plan become lines between cells, so that walls keep their thickness in
/// cells and two spaces that share a wall's centre line agree on where it is.
class PlanPainter {
 public:
  PlanPainter(const FloorPlan& plan, const OfficeBuildingOptions& options)
      : plan_(plan),
        grid_(geometryFor(plan, options.resolution)),
        wall_cells_(cellsFor(options.wall_thickness)),
        outer_wall_cells_(cellsFor(options.outer_wall_thickness)) {
    paint({{line(0.0), line(0.0)}, {line(plan.length), line(plan.width)}}, grid::kOccupied);
  }

  /// Clears the floor of a space; its walls remain.
  void clear(const Space& space) { paint(floorCells(space), grid::kFree); }

  /// Clears the wall that a door is in.
  void clear(const Door& door) {
    const double half = 0.5 * door.width;
    const int thickness = wall_cells_;
    if (door.in_wall_along_x) {
      const int wall = line(door.centre.y());
      paint({{line(door.centre.x() - half), wall - thickness}, {line(door.centre.x() + half), wall + thickness}},
            grid::kFree);
    } else {
      const int wall = line(door.centre.x());
      paint({{wall - thickness, line(door.centre.y() - half)}, {wall + thickness, line(door.centre.y() + half)}},
            grid::kFree);
    }
  }

  /// Draws a solid as far as it lies on the floor of a space.
  void add(const Solid& solid, const Space& space) {
    const CellRange floor = floorCells(space);
    const double reach = solid.half_size.norm() + grid_.resolution();
    const Eigen::Vector2d centre = solid.pose.translation();
    const grid::Cell low = grid_.geometry().cellAt(centre - Eigen::Vector2d(reach, reach));
    const grid::Cell high = grid_.geometry().cellAt(centre + Eigen::Vector2d(reach, reach));
    for (int y = std::max(low.y, floor.first.y); y < std::min(high.y + 1, floor.last.y); ++y) {
      for (int x = std::max(low.x, floor.first.x); x < std::min(high.x + 1, floor.last.x); ++x) {
        if (covers(solid, grid_.geometry().cellCentre({x, y}))) {
          grid_.at(x, y) = grid::kOccupied;
        }
      }
    }
  }

  grid::OccupancyGrid take() { return std::move(grid_); }

 private:
  static grid::GridGeometry geometryFor(const FloorPlan& plan, double resolution) {
    grid::GridGeometry geometry;
    geometry.resolution = resolution;
    const int margin = static_cast<int>(std::ceil(kMargin / resolution));
    geometry.width = static_cast<int>(std::lround(plan.length / resolution)) + 2 * margin;
    geometry.height = static_cast<int>(std::lround(plan.width / resolution)) + 2 * margin;
    geometry.T_map_grid = {-margin * resolution, -margin * resolution, 0.0};
    return geometry;
  }

  int cellsFor(double thickness) const {
    return std::max(1, static_cast<int>(std::lround(thickness / grid_.resolution())));
  }

  /// Index of the first cell beyond a coordinate of the plan.
  int line(double coordinate) const {
    const auto margin = static_cast<int>(std::ceil(kMargin / grid_.resolution()));
    return static_cast<int>(std::lround(coordinate / grid_.resolution())) + margin;
  }

  CellRange floorCells(const Space& space) const {
    const int low = (wall_cells_ + 1) / 2;
    const int high = wall_cells_ / 2;
    const Rectangle& walls = space.walls;
    return {{line(walls.x_min) + (walls.x_min <= 0.0 ? outer_wall_cells_ : low),
             line(walls.y_min) + (walls.y_min <= 0.0 ? outer_wall_cells_ : low)},
            {line(walls.x_max) - (walls.x_max >= plan_.length ? outer_wall_cells_ : high),
             line(walls.y_max) - (walls.y_max >= plan_.width ? outer_wall_cells_ : high)}};
  }

  /// Thin solids are drawn thick enough not to fall between the centres of cells.
  bool covers(const Solid& solid, const Eigen::Vector2d& p_plan) const {
    const double thinnest = 0.708 * grid_.resolution();
    const Eigen::Vector2d p = solid.pose.inverse() * p_plan;
    if (solid.is_round) {
      return p.norm() <= std::max(solid.half_size.x(), thinnest);
    }
    return std::abs(p.x()) <= std::max(solid.half_size.x(), thinnest) &&
           std::abs(p.y()) <= std::max(solid.half_size.y(), thinnest);
  }

  void paint(const CellRange& cells, std::int8_t value) {
    for (int y = cells.first.y; y < cells.last.y; ++y) {
      for (int x = cells.first.x; x < cells.last.x; ++x) {
        grid_.at(x, y) = value;
      }
    }
  }

  const FloorPlan& plan_;
  grid::OccupancyGrid grid_;
  int wall_cells_;
  int outer_wall_cells_;
};

}  // namespace

parameters::ParameterList parametersOf(OfficeBuildingOptions& options) {
  return {
      {"resolution", "m", "Edge length of a cell.", &options.resolution, 0.01, 0.1},
      {"length", "m", "Along x, outer walls included.", &options.length, 40.0, 200.0},
      {"width", "m", "Along y, outer walls included.", &options.width, 13.0, 30.0},
      {"wall_thickness", "m", "Walls between rooms; at least one cell.", &options.wall_thickness, 0.01, 0.4},
      {"outer_wall_thickness", "m", "Walls around the building; at least one cell.", &options.outer_wall_thickness,
       0.01, 0.5},
      {"door_width", "m", "Ordinary doors; some are wider.", &options.door_width, 0.9, 1.2},
      {"furnished", "", "Whether there is anything but walls and doors.", &options.furnished},
      {"moved_furniture", "", "Share of the furniture that was moved elsewhere in its room.", &options.moved_furniture,
       0.0, 1.0},
      {"shut_doors", "", "Share of the ordinary doors that are shut.", &options.shut_doors, 0.0, 1.0},
      {"copied_rooms", "m", "Width of rooms that are all the same; 0: every room is different.", &options.copied_rooms,
       0.0, 8.0},
      {"copied_furniture", "", "Whether such rooms have the same furniture, too.", &options.copied_furniture},
  };
}

grid::OccupancyGrid officeBuilding(const OfficeBuildingOptions& options) {
  const FloorPlan plan = drawFloorPlan(options);
  PlanPainter painter(plan, options);
  for (const Space& space : plan.spaces) {
    painter.clear(space);
  }
  for (const Door& door : plan.doors) {
    if (!door.is_shut) {
      painter.clear(door);
    }
  }
  if (options.furnished) {
    const std::vector<FurnishedSpace> furnished = furnish(plan, options);
    for (std::size_t i = 0; i < furnished.size(); ++i) {
      for (const Furniture& piece : furnished[i].pieces) {
        for (const Solid& solid : piece.solids) {
          painter.add(solid, plan.spaces[i]);
        }
      }
    }
  }
  return painter.take();
}

grid::OccupancyGrid officeFloors(const OfficeBuildingOptions& options, int num_floors) {
  if (num_floors < 1) {
    throw std::invalid_argument("there are " + std::to_string(num_floors) + " floors, expected at least 1");
  }
  OfficeBuildingOptions floor = options;
  floor.furniture_seed = furnitureSeedOf(options);
  grid::GridGeometry geometry;
  std::vector<std::int8_t> values;
  for (int k = 0; k < num_floors; ++k, ++floor.furniture_seed) {
    const grid::OccupancyGrid drawn = officeBuilding(floor);
    geometry = drawn.geometry();
    values.insert(values.end(), drawn.values().begin(), drawn.values().end());
  }
  geometry.height *= num_floors;
  return {geometry, std::move(values)};
}

}  // namespace map_matcher::simulation
