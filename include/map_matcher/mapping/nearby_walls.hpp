/// \file
/// The walls around the ends of beams, found quickly.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "map_matcher/mapping/hit_counting_grid.hpp"

namespace map_matcher::mapping {

/// A piece of wall.
struct WallPiece {
  Eigen::Vector2d middle{0.0, 0.0};  ///< On the wall [m].
  Eigen::Vector2d normal{0.0, 0.0};  ///< Across it, of length 1.
  double variance = 0.0;             ///< Of what it was drawn from, across it [m^2].
};

/// What a grid believes to be walls, for many questions about a part of it. The grid must not change meanwhile. Looks
/// at the grid block by block when it is asked.
class NearbyWalls {
 public:
  /// Answers about points in `extent`.
  NearbyWalls(const HitCountingGrid& grid, double occupied_threshold, const Extent& extent);

  /// Index of the wall point nearest to a point within `reach` [m], to be used with pieceAround(); nullopt: there is
  /// none.
  std::optional<int> nearest(const Eigen::Vector2d& point, double reach);

  /// The wall within `radius` [m] of a wall point; nullopt when what is there is no straight piece, such as a leg or a
  /// corner.
  std::optional<WallPiece> pieceAround(int wall_point, double radius);

  const WallPoint& at(int wall_point) const { return points_[static_cast<std::size_t>(wall_point)]; }

 private:
  struct Block {
    int begin = -1;  // of its points; -1: not looked at yet
    int end = -1;
  };

  template <typename Visit>
  void visitWithin(const Eigen::Vector2d& point, double radius, Visit&& visit);
  const Block& blockAt(int column, int row);

  const HitCountingGrid& grid_;
  double occupied_threshold_;
  Eigen::Vector2d corner_;
  int columns_;
  int rows_;
  std::vector<Block> blocks_;
  std::vector<WallPoint> points_;
};

}  // namespace map_matcher::mapping
