#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "map_matcher/search/refinement/distance_field.hpp"

namespace map_matcher::search {
namespace {

/// A wall along y in the column x = 20 of a map of 40 x 40 cells.
std::vector<grid::Cell> straightWall() {
  std::vector<grid::Cell> walls;
  for (int y = 0; y < 40; ++y) {
    walls.push_back({20, y});
  }
  return walls;
}

TEST(DistanceField, GradientIsTheWayFromTheMiddleOfTheWall) {
  const DistanceField field(40, 40, straightWall(), 8.0);

  for (const double x : {17.0, 19.2, 20.5, 20.9, 23.4}) {
    const DistanceField::Sample sample = field.at({x, 18.3});
    EXPECT_NEAR(sample.gradient.x(), x - 20.5, 1e-3) << x;
    EXPECT_NEAR(sample.gradient.y(), 0.0, 1e-4) << x;
    EXPECT_NEAR(sample.curvature(0, 0), 1.0, 1e-3) << x;
    EXPECT_NEAR(sample.curvature(1, 1), 0.0, 1e-3) << x;
    EXPECT_NEAR(sample.curvature(0, 1), 0.0, 1e-3) << x;
  }
}

TEST(DistanceField, IsFlatFarFromWallsAndBeyondTheMap) {
  const DistanceField field(40, 40, straightWall(), 6.0);

  for (const Eigen::Vector2d& far : {Eigen::Vector2d(5.0, 20.0), Eigen::Vector2d(-3.0, 20.0),
                                     Eigen::Vector2d(1e9, 20.0), Eigen::Vector2d(20.5, std::nan(""))}) {
    EXPECT_EQ(field.at(far).gradient.norm(), 0.0);
    EXPECT_EQ(field.at(far).curvature.norm(), 0.0);
  }
}

TEST(DistanceField, IsRoundAroundASingleWallCell) {
  const DistanceField field(40, 40, {{20, 20}}, 12.0);

  for (double angle = 0.0; angle < 6.0; angle += 0.5) {
    const Eigen::Vector2d way(6.0 * std::cos(angle), 6.0 * std::sin(angle));
    EXPECT_LT((field.at(Eigen::Vector2d(20.5, 20.5) + way).gradient - way).norm(), 0.1) << angle;
  }
}

}  // namespace
}  // namespace map_matcher::search
