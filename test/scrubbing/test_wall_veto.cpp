#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "map_matcher/scrubbing/wall_veto.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher {
namespace {

/// A wall from x = 0.4 to 0.5 m, 0.7 m high; unknown at the right.
OccupancyGrid wall() {
  return test::asciiMap(
      {"....#...??", "....#...??", "....#...??", "....#...??", "....#...??", "....#...??", "....#...??"}, 0.1);
}

TEST(WallVeto, KnowsPlacesNearAWall) {
  const WallVeto veto(wall(), 0.15);

  EXPECT_TRUE(veto.isOnWall({0.45, 0.35}));
  EXPECT_TRUE(veto.isOnWall({0.35, 0.35}));
  EXPECT_TRUE(veto.isOnWall({0.55, 0.35}));
  EXPECT_FALSE(veto.isOnWall({0.25, 0.35}));
  EXPECT_FALSE(veto.isOnWall({0.65, 0.35}));
}

TEST(WallVeto, TakesUnknownCellsForNoWalls) { EXPECT_FALSE(WallVeto(wall(), 0.15).isOnWall({0.95, 0.35})); }

TEST(WallVeto, KnowsNothingOutsideTheMap) {
  const WallVeto veto(wall(), 10.0);

  EXPECT_TRUE(veto.isOnWall({0.05, 0.05}));
  EXPECT_FALSE(veto.isOnWall({-0.05, 0.05}));
  EXPECT_FALSE(veto.isOnWall({std::numeric_limits<double>::quiet_NaN(), 0.05}));
}

TEST(WallVeto, FollowsTheOriginOfTheMap) {
  const Rigid2 T_map_grid{10.0, 20.0, M_PI_2};
  const OccupancyGrid turned({0.1, 10, 7, T_map_grid}, wall().values());
  const WallVeto veto(turned, 0.05);

  EXPECT_TRUE(veto.isOnWall(T_map_grid * Eigen::Vector2d(0.45, 0.35)));
  EXPECT_FALSE(veto.isOnWall(T_map_grid * Eigen::Vector2d(0.25, 0.35)));
}

TEST(WallVeto, VetoesNothingInAMapWithoutWalls) {
  EXPECT_FALSE(WallVeto(test::asciiMap({"...", "..."}), 1.0).isOnWall({1.5, 0.5}));
}

TEST(WallVeto, RefusesADistanceThatIsNone) {
  EXPECT_THROW(WallVeto(wall(), -0.1), std::invalid_argument);
  EXPECT_THROW(WallVeto(wall(), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher
