/// \file
/// Draws beams into a grid by counting.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/mapping/beams.hpp"

namespace map_matcher::mapping {

/// A rectangle of a frame [m].
struct Extent {
  Eigen::Vector2d min{0.0, 0.0};  ///< Lower left corner [m].
  Eigen::Vector2d max{0.0, 0.0};  ///< Upper right corner [m].
};

/// What the grid believes to be a wall: a cell in which enough of its beams ended.
struct WallPoint {
  Eigen::Vector2d position{0.0, 0.0};  ///< Mean of where they ended [m], finer than the cell.
  int hits = 0;                        ///< Number of beams that ended here at a wall.
};

/// Counts for every cell how many beams crossed it or ended in it, and how many ended in it at a wall. The quotient is
/// slam_gmapping's measure of occupancy. Cell (i, j) covers [i, i + 1) x [j, j + 1) cells of the frame, exactly: the
/// lines of the grid are the multiples of the resolution, however much it has grown, and a point becomes a cell by
/// floor. (slam_gmapping's own map lies half a cell off.)
class HitCountingGrid {
 public:
  static constexpr std::int64_t kMaxCells = 100'000'000;  ///< It never grows beyond this many cells (800 MB).

  /// Covers `extent`, rounded outwards to whole cells, with cells that nobody has seen. Throws std::invalid_argument
  /// when the resolution is not positive and finite, the extent is not finite or empty, or it takes more than
  /// kMaxCells.
  HitCountingGrid(double resolution, const Extent& extent);

  /// Draws the beams of a fan, given in the frame of the grid, and grows the grid by multiples of 32 cells where they
  /// leave it. Returns false, and draws nothing, when it would have to grow beyond kMaxCells.
  bool draw(const BeamFan& fan);

  /// The walls in a rectangle, row by row.
  std::vector<WallPoint> wallsIn(const Extent& extent, double occupied_threshold) const;

  /// Whether any beam came to the cell of a point.
  bool isKnown(const Eigen::Vector2d& point) const;

  /// Share of the beams of a fan that end more than `margin` [m] behind a wall: nobody sees through a wall. People who
  /// stand in the way of beams never cause it. 0 without beams.
  double shareThroughWalls(const BeamFan& fan, double occupied_threshold, double margin) const;

  /// The counts as a map: kUnknown where no beam came, kOccupied where hits / visits > `occupied_threshold` [0 to 1],
  /// kFree elsewhere. Its origin has yaw 0.
  grid::OccupancyGrid toOccupancyGrid(double occupied_threshold) const;

 private:
  struct Counts {
    std::uint16_t hits = 0;    // beams that ended here at a wall
    std::uint16_t visits = 0;  // beams that crossed this cell or ended here
    std::uint16_t mean_x = 0;  // of where the hits lie in the cell [cells / 2^16]
    std::uint16_t mean_y = 0;
  };

  struct Line {
    Eigen::Vector2d from{0.0, 0.0};  // [m]
    Eigen::Vector2d to{0.0, 0.0};
  };

  grid::Cell latticeCell(const Eigen::Vector2d& point) const;
  bool growTo(const grid::Cell& lower, const grid::Cell& upper);
  template <typename Visit>
  void visitCells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visit&& visit) const;
  std::optional<Line> partWithin(const Line& line) const;
  void count(const grid::Cell& lattice_cell, const Eigen::Vector2d& end, bool hit);
  static bool isWall(const Counts& counts, double occupied_threshold) {
    return counts.hits > occupied_threshold * counts.visits;
  }
  bool holds(const grid::Cell& lattice_cell) const;
  std::size_t indexOf(const grid::Cell& lattice_cell) const;

  double resolution_;
  grid::Cell first_;  // lattice index of the lower left cell
  int width_;
  int height_;
  std::vector<Counts> counts_;  // row-major from the lower left
};

}  // namespace map_matcher::mapping
