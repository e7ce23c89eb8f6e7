#include <gtest/gtest.h>

#include <random>

#include "map_matcher/search/score_kernel.hpp"
#include "support/random_maps.hpp"

namespace map_matcher {
namespace {

/// A random small problem: a level of a map, cells, and a translation, partly far outside the map.
struct Problem {
  explicit Problem(std::uint32_t seed) : random(seed) {
    const int width = test::randomInt(random, 1, 300);
    const int height = test::randomInt(random, 1, 100);
    const int num_walls = test::randomInt(random, 1, width * height);
    grids.emplace_back(width, height, test::randomCells(random, width, height, num_walls), 3);
    cells = test::randomRotatedCells(random, 150, test::randomInt(random, 1, 700));
    first = {test::randomInt(random, -400, 400), test::randomInt(random, -300, 300)};
  }

  std::mt19937 random;
  std::vector<PrecomputedGrids> grids;
  RotatedCells cells;
  Cell first;
};

TEST(ScoreKernel, CountsEveryTranslationOfATileAsOneByOneInEveryVariant) {
  for (const KernelVariant variant : availableKernelVariants()) {
    const ScoreKernel kernel(variant);
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
      const Problem problem(seed);
      const PooledLevel& level = problem.grids[0].level(static_cast<int>(seed % 4));
      for (const TileShape shape : {TileShape::kWide, TileShape::kNarrow}) {
        SCOPED_TRACE(testing::Message() << "variant " << static_cast<int>(variant) << " seed " << seed);
        TileCounts counts;

        ASSERT_TRUE(kernel.scoreTile(shape, level, problem.cells, problem.first, 0, counts));

        for (int row = 0; row < tileRows(shape); ++row) {
          for (int column = 0; column < tileColumns(shape); ++column) {
            const Cell translation{problem.first.x + column * level.stride(), problem.first.y + row * level.stride()};
            ASSERT_EQ(counts[static_cast<std::size_t>(row * tileColumns(shape) + column)],
                      test::countMatches(level, problem.cells, translation))
                << "column " << column << " row " << row;
          }
        }
      }
    }
  }
}

TEST(ScoreKernel, CountsTheFourChildrenAsOneByOneInEveryVariant) {
  for (const KernelVariant variant : availableKernelVariants()) {
    const ScoreKernel kernel(variant);
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE(testing::Message() << "variant " << static_cast<int>(variant) << " seed " << seed);
      const Problem problem(seed);
      const PooledLevel& level = problem.grids[0].level(static_cast<int>(seed % 4));
      std::array<std::int32_t, 4> counts;

      ASSERT_TRUE(kernel.scoreChildren(level, problem.cells, problem.first, 0, counts));

      for (int k = 0; k < 4; ++k) {
        const Cell translation{problem.first.x + (k & 1) * level.stride(), problem.first.y + (k >> 1) * level.stride()};
        ASSERT_EQ(counts[static_cast<std::size_t>(k)], test::countMatches(level, problem.cells, translation));
      }
    }
  }
}

TEST(ScoreKernel, GivesATileUpOnlyWhenNoneOfItsTranslationsReachesTheMinimum) {
  const ScoreKernel kernel;
  int given_up = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem(seed);
    const PooledLevel& level = problem.grids[0].level(1);
    TileCounts counts;
    kernel.scoreTile(TileShape::kWide, level, problem.cells, problem.first, 0, counts);
    const std::int32_t best = *std::max_element(counts.begin(), counts.end());

    EXPECT_TRUE(kernel.scoreTile(TileShape::kWide, level, problem.cells, problem.first, best, counts));
    given_up += kernel.scoreTile(TileShape::kWide, level, problem.cells, problem.first, best + 1, counts) ? 0 : 1;
  }
  EXPECT_EQ(given_up, 60);
}

}  // namespace
}  // namespace map_matcher
