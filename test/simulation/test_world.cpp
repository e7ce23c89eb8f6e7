#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "map_matcher/simulation/office_building.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/world.hpp"
#include "support/ascii_map.hpp"
#include "support/ray_oracle.hpp"

namespace map_matcher::simulation {
namespace {

using test::asciiMap;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A grid with a share of solid and of unknown cells, turned and moved in its map.
grid::OccupancyGrid randomGrid(double solid, double unknown, RandomNumbers& random) {
  grid::GridGeometry geometry;
  geometry.resolution = random.uniform(0.02, 0.1);
  geometry.width = 20 + static_cast<int>(random.index(60));
  geometry.height = 20 + static_cast<int>(random.index(60));
  geometry.T_map_grid = {random.uniform(-5.0, 5.0), 3.0, random.uniform(-M_PI, M_PI)};
  grid::OccupancyGrid grid(geometry);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      grid.at(x, y) = random.chance(solid) ? grid::kOccupied : random.chance(unknown) ? grid::kUnknown : grid::kFree;
    }
  }
  return grid;
}

Eigen::Vector2d randomPoint(const grid::OccupancyGrid& grid, RandomNumbers& random) {
  const double x = random.uniform(0.0, grid.width() * grid.resolution());
  const double y = random.uniform(0.0, grid.height() * grid.resolution());
  return grid.geometry().T_map_grid * Eigen::Vector2d(x, y);
}

TEST(World, raysEndWhereTheyEnterTheFirstSolidCell) {
  const World world(asciiMap({"........#",  //
                              "........#",  //
                              "....#...#"}));
  EXPECT_DOUBLE_EQ(world.castRay({0.5, 0.5}, 0.0, 20.0), 3.5);
  EXPECT_DOUBLE_EQ(world.castRay({0.5, 1.5}, 0.0, 20.0), 7.5);
  EXPECT_NEAR(world.castRay({4.5, 2.5}, -M_PI / 2.0, 20.0), 1.5, 1e-12);
  EXPECT_EQ(world.castRay({6.5, 2.5}, M_PI, 20.0), kInfinity);
}

TEST(World, nothingIsSeenBehindASolidCell) {
  const World world(asciiMap({"..#..#"}));
  EXPECT_DOUBLE_EQ(world.castRay({0.5, 0.5}, 0.0, 20.0), 1.5);
}

TEST(World, raysPassUnknownCells) {
  const World world(asciiMap({".???#"}));
  EXPECT_DOUBLE_EQ(world.castRay({0.5, 0.5}, 0.0, 20.0), 3.5);
}

TEST(World, raysMeetNothingBeyondTheirRangeNorOutsideTheGrid) {
  const World world(asciiMap({"....#"}));
  EXPECT_EQ(world.castRay({0.5, 0.5}, 0.0, 3.4), kInfinity);
  EXPECT_DOUBLE_EQ(world.castRay({0.5, 0.5}, 0.0, 3.6), 3.5);
  EXPECT_EQ(world.castRay({0.5, 0.5}, M_PI / 2.0, 20.0), kInfinity);
  EXPECT_EQ(world.castRay({-0.5, 0.5}, 0.0, 20.0), kInfinity);
  EXPECT_EQ(world.castRay({5.5, 0.5}, M_PI, 20.0), kInfinity);
}

TEST(World, aRayFromASolidCellHasNoLength) {
  const World world(asciiMap({"..#.."}));
  EXPECT_EQ(world.castRay({2.5, 0.5}, 1.0, 20.0), 0.0);
}

TEST(World, refusesRaysThatAreNotFinite) {
  const World world(asciiMap({"..#"}));
  EXPECT_THROW(world.castRay({0.5, 0.5}, kInfinity, 20.0), std::invalid_argument);
  EXPECT_THROW(world.castRay({std::nan(""), 0.5}, 0.0, 20.0), std::invalid_argument);
  EXPECT_THROW(world.castRay({0.5, 0.5}, 0.0, kInfinity), std::invalid_argument);
}

TEST(World, refusesAThresholdOutOfItsRange) {
  const grid::OccupancyGrid grid = asciiMap({".#"});
  EXPECT_THROW(World(grid, 0), std::invalid_argument);
  EXPECT_THROW(World(grid, 101), std::invalid_argument);
}

TEST(World, cellsFromTheThresholdOnAreSolid) {
  grid::OccupancyGrid grid = asciiMap({"....."});
  grid.at(2, 0) = 50;
  grid.at(4, 0) = 80;
  EXPECT_DOUBLE_EQ(World(grid).castRay({0.5, 0.5}, 0.0, 20.0), 3.5);
  EXPECT_DOUBLE_EQ(World(grid, 50).castRay({0.5, 0.5}, 0.0, 20.0), 1.5);
}

TEST(World, raysAgreeWithLookingAtEveryCellOfRandomGrids) {
  constexpr std::uint64_t kSeed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  RandomNumbers random(kSeed);
  int hits = 0;
  for (int i = 0; i < 60; ++i) {
    const grid::OccupancyGrid grid = randomGrid(random.uniform(0.0, 0.1), 0.1, random);
    const World world(grid);
    for (int ray = 0; ray < 200; ++ray) {
      const Eigen::Vector2d origin = randomPoint(grid, random);
      const double heading = random.uniform(-10.0, 10.0);
      const double expected = test::castRayByEveryCell(grid, origin, heading);
      const double range = world.castRay(origin, heading, 100.0);
      hits += std::isfinite(range) ? 1 : 0;
      if (std::isfinite(expected)) {
        ASSERT_NEAR(range, expected, 1e-9) << "grid " << i << ", from " << origin.transpose() << " heading " << heading;
      } else {
        ASSERT_EQ(range, expected) << "grid " << i << ", from " << origin.transpose() << " heading " << heading;
      }
    }
  }
  EXPECT_GT(hits, 6000);  // the comparison was about walls
}

TEST(World, raysAgreeWithLookingAtEveryCellOfABuilding) {
  constexpr std::uint64_t kSeed = 12;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  RandomNumbers random(kSeed);
  OfficeBuildingOptions options;
  options.seed = kSeed;
  const grid::OccupancyGrid building = officeBuilding(options);
  const World world(building);
  for (int ray = 0; ray < 60; ++ray) {
    const Eigen::Vector2d origin(random.uniform(0.0, options.length), random.uniform(0.0, options.width));
    const double heading = random.uniform(-M_PI, M_PI);
    ASSERT_NEAR(world.castRay(origin, heading, 100.0), test::castRayByEveryCell(building, origin, heading), 1e-9)
        << "from " << origin.transpose() << " heading " << heading;
  }
}

TEST(World, clearanceIsLittleLessThanTheTrueDistanceAndIsClearIsExact) {
  constexpr std::uint64_t kSeed = 13;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  RandomNumbers random(kSeed);
  for (int i = 0; i < 40; ++i) {
    const grid::OccupancyGrid grid = randomGrid(random.uniform(0.0, 0.05), random.uniform(0.0, 0.02), random);
    const World world(grid);
    for (int j = 0; j < 200; ++j) {
      const Eigen::Vector2d p = randomPoint(grid, random);
      const double expected = test::clearanceByEveryCell(grid, p);
      ASSERT_LE(world.clearance(p), expected + 1e-9) << "grid " << i << " at " << p.transpose();
      ASSERT_GE(world.clearance(p), expected - 1.7 * grid.resolution()) << "grid " << i << " at " << p.transpose();
      ASSERT_TRUE(expected == 0.0 || world.isClear(p, expected - 1e-9)) << "grid " << i << " at " << p.transpose();
      ASSERT_FALSE(world.isClear(p, expected + 1e-9)) << "grid " << i << " at " << p.transpose();
    }
  }
}

TEST(World, thereIsNoClearanceInSolidOrUnknownCellsNorOutside) {
  const World world(asciiMap({".....", ".....", "..#?.", ".....", "....."}));
  EXPECT_EQ(world.clearance({2.5, 2.5}), 0.0);
  EXPECT_EQ(world.clearance({3.5, 2.5}), 0.0);
  EXPECT_EQ(world.clearance({-1.0, 2.5}), 0.0);
  EXPECT_EQ(world.clearance({2.5, 7.0}), 0.0);
  EXPECT_EQ(world.clearance({std::nan(""), 2.5}), 0.0);
  EXPECT_FALSE(world.isClear({2.5, 2.5}, 0.1));
  EXPECT_FALSE(world.isClear({3.5, 2.5}, 0.1));
  EXPECT_FALSE(world.isClear({-1e12, 2.5}, 0.1));
  EXPECT_FALSE(world.isClear({std::nan(""), 2.5}, 0.1));
  EXPECT_TRUE(world.isClear({0.5, 4.5}, 0.5));
  EXPECT_FALSE(world.isClear({4.5, 4.5}, 0.6));
}

}  // namespace
}  // namespace map_matcher::simulation
