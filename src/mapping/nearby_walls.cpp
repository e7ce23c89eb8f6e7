#include "map_matcher/mapping/nearby_walls.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace map_matcher::mapping {
namespace {

constexpr double kBlock = 0.25;        // [m] edge length of a block
constexpr double kMostBlocks = 4000;   // along a side
constexpr int kLeastPoints = 3;        // of a straight piece
constexpr double kMostHits = 8.0;      // that count: what was seen often is not more exact for ever
constexpr double kStraightness = 0.2;  // largest variance across a straight piece, as a share of that along it

int blocksOver(double length) { return static_cast<int>(std::clamp(std::ceil(length / kBlock), 1.0, kMostBlocks)); }

}  // namespace

NearbyWalls::NearbyWalls(const HitCountingGrid& grid, double occupied_threshold, const Extent& extent)
    : grid_(grid),
      occupied_threshold_(occupied_threshold),
      corner_(extent.min),
      columns_(blocksOver(extent.max.x() - extent.min.x())),
      rows_(blocksOver(extent.max.y() - extent.min.y())),
      blocks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

const NearbyWalls::Block& NearbyWalls::blockAt(int column, int row) {
  Block& block =
      blocks_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  if (block.begin < 0) {
    const Eigen::Vector2d lower = corner_ + kBlock * Eigen::Vector2d(column, row);
    const Eigen::Vector2d upper = lower + Eigen::Vector2d::Constant(kBlock);
    block.begin = static_cast<int>(points_.size());
    for (const WallPoint& wall : grid_.wallsIn({lower, upper}, occupied_threshold_)) {
      // Blocks share cells at their borders, but no points.
      if ((wall.position.array() >= lower.array()).all() && (wall.position.array() < upper.array()).all()) {
        points_.push_back(wall);
      }
    }
    block.end = static_cast<int>(points_.size());
  }
  return block;
}

template <typename Visit>
void NearbyWalls::visitWithin(const Eigen::Vector2d& point, double radius, Visit&& visit) {
  const Eigen::Vector2d place = (point - corner_) / kBlock;
  const double reach = radius / kBlock;
  if (!(place.x() + reach >= 0.0 && place.y() + reach >= 0.0 && place.x() - reach < columns_ &&
        place.y() - reach < rows_)) {
    return;
  }
  const int left = std::max(0, static_cast<int>(std::floor(place.x() - reach)));
  const int right = std::min(columns_ - 1, static_cast<int>(std::floor(place.x() + reach)));
  const int top = std::min(rows_ - 1, static_cast<int>(std::floor(place.y() + reach)));
  for (int row = std::max(0, static_cast<int>(std::floor(place.y() - reach))); row <= top; ++row) {
    for (int column = left; column <= right; ++column) {
      const Block block = blockAt(column, row);
      for (int k = block.begin; k < block.end; ++k) {
        const double square = (points_[static_cast<std::size_t>(k)].position - point).squaredNorm();
        if (square <= radius * radius) {
          visit(k, square);
        }
      }
    }
  }
}

std::optional<int> NearbyWalls::nearest(const Eigen::Vector2d& point, double reach) {
  std::optional<int> best;
  double least = 0.0;
  visitWithin(point, reach, [&](int k, double square) {
    if (!best || square < least) {
      best = k;
      least = square;
    }
  });
  return best;
}

std::optional<WallPiece> NearbyWalls::pieceAround(int wall_point, double radius) {
  int num_points = 0;
  double weights = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  const Eigen::Vector2d middle = at(wall_point).position;
  visitWithin(middle, radius, [&](int k, double /*square*/) {
    const double weight = std::min<double>(at(k).hits, kMostHits);
    const Eigen::Vector2d from_middle = at(k).position - middle;
    ++num_points;
    weights += weight;
    sum += weight * from_middle;
    squares += weight * from_middle * from_middle.transpose();
  });
  if (num_points < kLeastPoints) {
    return std::nullopt;
  }
  const Eigen::Vector2d mean = sum / weights;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(squares / weights - mean * mean.transpose());
  if (solver.eigenvalues()[0] > kStraightness * solver.eigenvalues()[1]) {
    return std::nullopt;
  }
  return WallPiece{middle + mean, solver.eigenvectors().col(0), std::max(0.0, solver.eigenvalues()[0])};
}

}  // namespace map_matcher::mapping
