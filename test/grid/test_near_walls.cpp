#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "map_matcher/grid/near_walls.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::grid {
namespace {

/// A wall from x = 0.4 to 0.5 m, 0.7 m high; unknown at the right.
OccupancyGrid wall() {
  return test::asciiMap(
      {"....#...??", "....#...??", "....#...??", "....#...??", "....#...??", "....#...??", "....#...??"}, 0.1);
}

TEST(NearWalls, HoldPlacesBesideAWall) {
  const NearWalls near_walls(wall(), 0.15);

  EXPECT_TRUE(near_walls.isNearWall({0.45, 0.35}));
  EXPECT_TRUE(near_walls.isNearWall({0.35, 0.35}));
  EXPECT_TRUE(near_walls.isNearWall({0.55, 0.35}));
  EXPECT_FALSE(near_walls.isNearWall({0.25, 0.35}));
  EXPECT_FALSE(near_walls.isNearWall({0.65, 0.35}));
}

TEST(NearWalls, TakeUnknownCellsForNoWalls) { EXPECT_FALSE(NearWalls(wall(), 0.15).isNearWall({0.95, 0.35})); }

TEST(NearWalls, EndWithTheMap) {
  const NearWalls near_walls(wall(), 10.0);

  EXPECT_TRUE(near_walls.isNearWall({0.05, 0.05}));
  EXPECT_FALSE(near_walls.isNearWall({-0.05, 0.05}));
  EXPECT_FALSE(near_walls.isNearWall({std::numeric_limits<double>::quiet_NaN(), 0.05}));
}

TEST(NearWalls, FollowTheOriginOfTheMap) {
  const Rigid2 T_map_grid{10.0, 20.0, M_PI_2};
  const OccupancyGrid turned({0.1, 10, 7, T_map_grid}, wall().values());
  const NearWalls near_walls(turned, 0.05);

  EXPECT_TRUE(near_walls.isNearWall(T_map_grid * Eigen::Vector2d(0.45, 0.35)));
  EXPECT_FALSE(near_walls.isNearWall(T_map_grid * Eigen::Vector2d(0.25, 0.35)));
}

TEST(NearWalls, AreNowhereInAMapWithoutWalls) {
  EXPECT_FALSE(NearWalls(test::asciiMap({"...", "..."}), 1.0).isNearWall({1.5, 0.5}));
}

TEST(NearWalls, RefuseADistanceThatIsNone) {
  EXPECT_THROW(NearWalls(wall(), -0.1), std::invalid_argument);
  EXPECT_THROW(NearWalls(wall(), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher::grid
