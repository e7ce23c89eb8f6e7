#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "map_matcher/search/counting/widened_grids.hpp"
#include "support/exact_oracle.hpp"
#include "support/random_maps.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::search {
namespace {

bool hitWithin(const test::HitMap& hits, const grid::Cell& first, int size) {
  for (int y = first.y; y < first.y + size; ++y) {
    for (int x = first.x; x < first.x + size; ++x) {
      if (hits.at(x, y)) {
        return true;
      }
    }
  }
  return false;
}

TEST(WidenedGrids, AreOneWhereAHitLiesInTheWindow) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const int width = test::randomInt(random, 1, 40);
    const int height = test::randomInt(random, 1, 40);
    const std::vector<grid::Cell> walls = test::randomCells(random, width, height, test::randomInt(random, 1, 12));
    const double tolerance = 0.5 * test::randomInt(random, 0, 6);
    const test::HitMap hits(width, height, walls, tolerance);

    const WidenedGrids grids(width, height, walls, tolerance, BlockShape::kMaxLevel);

    for (int trial = 0; trial < 500; ++trial) {
      const int level = trial % (BlockShape::kMaxLevel + 1);
      const int grain = BlockShape{level}.grain();
      const grid::Cell first{test::randomInt(random, -70, 70) * grain, test::randomInt(random, -70, 70) * grain};
      const grid::Cell position = grids.position(level, first);
      ASSERT_EQ(grids.level(level).at(position.x, position.y),
                hitWithin(hits, first, BlockShape{level}.window()) ? 1 : 0)
          << "level " << level << " at " << first.x << " " << first.y << ", tolerance " << tolerance;
    }
  }
}

TEST(WidenedGrids, BoxHoldsAllHits) {
  const WidenedGrids grids(10, 8, {{2, 3}, {7, 4}}, 1.5, 2);

  EXPECT_EQ(grids.firstHit(), (grid::Cell{1, 2}));
  EXPECT_EQ(grids.lastHit(), (grid::Cell{8, 5}));
}

TEST(WidenedGrids, AcceptAToleranceLargerThanTheMap) {
  const WidenedGrids grids(4, 3, {{1, 1}}, 1e9, 3);

  const grid::Cell wall = grids.position(0, {1, 1});
  EXPECT_EQ(grids.level(0).at(wall.x, wall.y), 1);
  EXPECT_EQ(grids.level(0).at(wall.x + 3, wall.y), 1);
}

TEST(WidenedGrids, RefuseWhatTheyCannotPoolWithAReason) {
  using test::thrownText;
  EXPECT_NE(thrownText<std::invalid_argument>([] { WidenedGrids(0, 3, {}, 0.0, 1); }).find("0 x 3"), std::string::npos);
  EXPECT_NE(thrownText<std::invalid_argument>([] { WidenedGrids(3, 3, {}, std::nan(""), 1); }).find("nan"),
            std::string::npos);
  EXPECT_NE(thrownText<std::invalid_argument>([] { WidenedGrids(3, 3, {}, 0.0, 99); }).find("99"), std::string::npos);
}

}  // namespace
}  // namespace map_matcher::search
