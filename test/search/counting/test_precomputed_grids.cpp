#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "map_matcher/search/counting/precomputed_grids.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

TEST(PrecomputedGrids, HoldTheMaximumOfTheSlidingWindowAtEveryLevelAndPosition) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const int width = test::randomInt(random, 1, 40);
    const int height = test::randomInt(random, 1, 40);
    const std::vector<grid::Cell> walls = test::randomCells(random, width, height, test::randomInt(random, 1, 60));

    const PrecomputedGrids grids(width, height, walls, 4);

    for (int level = 0; level <= 4; ++level) {
      for (int y = -40; y < height + 40; ++y) {
        for (int x = -40; x < width + 40; ++x) {
          ASSERT_EQ(grids.level(level).at(x, y), test::wallWithin(walls, x, y, 1 << level) ? 1 : 0)
              << "level " << level << " at (" << x << ", " << y << ")";
        }
      }
    }
  }
}

TEST(PrecomputedGrids, OfBandsHoldTheMaximumOfTheWidenedWindow) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const int width = test::randomInt(random, 1, 40);
    const int height = test::randomInt(random, 1, 40);
    const std::vector<grid::Cell> walls = test::randomCells(random, width, height, test::randomInt(random, 1, 60));

    const PrecomputedGrids grids(width, height, walls, 0, 4);

    for (int level = 0; level <= 4; ++level) {
      for (int y = -40; y < height + 40; ++y) {
        for (int x = -40; x < width + 40; ++x) {
          const grid::Cell position = PrecomputedGrids::bandPosition({x, y});
          const int size = (1 << level) + 2 * kBandReach;
          ASSERT_EQ(grids.bandLevel(level).at(position.x, position.y),
                    test::wallWithin(walls, x - kBandReach, y - kBandReach, size) ? 1 : 0)
              << "level " << level << " at (" << x << ", " << y << ")";
        }
      }
    }
  }
}

TEST(PrecomputedGrids, AreZeroFarOutsideTheMap) {
  const PrecomputedGrids grids(3, 2, {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}, 2);

  for (const int far : {-100000, -500, 500, 100000}) {
    EXPECT_EQ(grids.level(2).at(far, 0), 0);
    EXPECT_EQ(grids.level(0).at(0, far), 0);
  }
}

TEST(PrecomputedGrids, KnowTheBoxOfTheWalls) {
  const PrecomputedGrids grids(10, 10, {{2, 7}, {5, 3}}, 0);

  EXPECT_EQ(grids.firstWall(), (grid::Cell{2, 3}));
  EXPECT_EQ(grids.lastWall(), (grid::Cell{5, 7}));
}

TEST(PrecomputedGrids, WithoutWallsHaveAnEmptyBox) {
  const PrecomputedGrids grids(10, 10, {}, 1);

  EXPECT_GT(grids.firstWall().x, grids.lastWall().x);
}

TEST(PrecomputedGrids, RejectSizesAndLevelsOutOfRange) {
  EXPECT_THROW(PrecomputedGrids(0, 4, {}, 1), std::invalid_argument);
  EXPECT_THROW(PrecomputedGrids(4, -1, {}, 1), std::invalid_argument);
  EXPECT_THROW(PrecomputedGrids(4, 4, {}, -1), std::invalid_argument);
  EXPECT_THROW(PrecomputedGrids(4, 4, {}, 16), std::invalid_argument);
  EXPECT_THROW(PrecomputedGrids(4, 4, {}, 2, 16), std::invalid_argument);
  EXPECT_THROW(PrecomputedGrids(60000, 60000, {}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher::search
