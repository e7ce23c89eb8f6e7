#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <vector>

#include "map_matcher/search/counting/score_kernel.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
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
  grid::Cell first;
};

TEST(ScoreKernel, CountsEveryTranslationOfATileAsOneByOneInEveryVariant) {
  for (const KernelVariant variant : availableKernelVariants()) {
    const ScoreKernel kernel(variant);
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
      SCOPED_TRACE(testing::Message() << "variant " << static_cast<int>(variant) << " seed " << seed);
      Problem problem(seed);
      const PooledLevel& level = problem.grids[0].level(static_cast<int>(seed % 4));
      const TileSize size{test::randomInt(problem.random, 1, kTileColumns),
                          test::randomInt(problem.random, 1, kTileRows)};
      std::vector<TileScore> scores;

      kernel.scoreTile(level, problem.cells, problem.first, size, 0, scores);

      ASSERT_EQ(scores.size(), static_cast<std::size_t>(size.columns * size.rows));
      std::size_t k = 0;
      for (int column = 0; column < size.columns; ++column) {
        for (int row = 0; row < size.rows; ++row, ++k) {
          const grid::Cell translation{problem.first.x + column * level.stride(),
                                       problem.first.y + row * level.stride()};
          ASSERT_EQ(scores[k].column, column);
          ASSERT_EQ(scores[k].row, row);
          ASSERT_EQ(scores[k].count, test::countMatches(level, problem.cells, translation))
              << "column " << column << " row " << row;
        }
      }
    }
  }
}

TEST(ScoreKernel, BestCountIsTheLargestOfAllInEveryVariant) {
  for (const KernelVariant variant : availableKernelVariants()) {
    const ScoreKernel kernel(variant);
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
      SCOPED_TRACE(testing::Message() << "variant " << static_cast<int>(variant) << " seed " << seed);
      Problem problem(seed);
      const PooledLevel& level = problem.grids[0].level(static_cast<int>(seed % 4));
      const TileSize size{test::randomInt(problem.random, 1, kTileColumns),
                          test::randomInt(problem.random, 1, kTileRows)};
      std::vector<TileScore> scores;
      kernel.scoreTile(level, problem.cells, problem.first, size, 0, scores);
      const auto best = std::max_element(scores.begin(), scores.end(),
                                         [](const TileScore& a, const TileScore& b) { return a.count < b.count; });

      EXPECT_EQ(kernel.bestCount(level, problem.cells, problem.first, size), best->count);
    }
  }
}

TEST(ScoreKernel, CountsWeightedCellsAsOftenAsTheyWeighInEveryVariant) {
  for (const KernelVariant variant : availableKernelVariants()) {
    const ScoreKernel kernel(variant);
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(testing::Message() << "variant " << static_cast<int>(variant) << " seed " << seed);
      Problem problem(seed);
      const PooledLevel& level = problem.grids[0].level(static_cast<int>(seed % 4));
      WeightedCells weighted;
      RotatedCells repeated;  // each as often as it weighs
      for (const std::int32_t weight : {1024, 100, 47, 16, 13, 7, 5, 3, 2, 1}) {
        const int size = test::randomInt(problem.random, 0, 900 / weight);
        const RotatedCells cells = test::randomRotatedCells(problem.random, 150, size);
        for (int k = 0; k < size; ++k) {
          weighted.cells.x.push_back(cells.x[static_cast<std::size_t>(k)]);
          weighted.cells.y.push_back(cells.y[static_cast<std::size_t>(k)]);
          repeated.x.insert(repeated.x.end(), static_cast<std::size_t>(weight), weighted.cells.x.back());
          repeated.y.insert(repeated.y.end(), static_cast<std::size_t>(weight), weighted.cells.y.back());
        }
        weighted.runs.push_back({static_cast<std::size_t>(size), weight});
        weighted.total += size * weight;
      }
      std::vector<TileScore> scores;

      kernel.scoreTile(level, weighted, problem.first, {}, 1, scores);

      for (const TileScore& score : scores) {
        const grid::Cell translation{problem.first.x + score.column * level.stride(),
                                     problem.first.y + score.row * level.stride()};
        ASSERT_EQ(score.count, test::countMatches(level, repeated, translation));
      }
    }
  }
}

TEST(ScoreKernel, LooksAtThePartOfATileThatIsWantedAndNoOther) {
  const ScoreKernel kernel;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem(seed);
    const PooledLevel& level = problem.grids[0].level(1);
    const auto total = static_cast<std::int32_t>(problem.cells.x.size());
    const WeightedCells cells{problem.cells, {{problem.cells.x.size(), 1}}, total};
    TileMask wanted{};
    for (TileWord& word : wanted) {
      word = static_cast<TileWord>(problem.random() & problem.random());
    }
    std::vector<TileScore> all;
    kernel.scoreTile(level, problem.cells, problem.first, {}, 0, all);
    for (const std::int32_t min_count : {0, total / 4}) {
      std::vector<TileScore> expected;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected), [&](const TileScore& score) {
        return score.count >= min_count && (wanted[static_cast<std::size_t>(score.column)] >> score.row & 1) != 0;
      });
      std::vector<TileScore> scores;

      kernel.scorePart(level, cells, problem.first, wanted, min_count, scores);

      ASSERT_EQ(scores.size(), expected.size()) << "min_count " << min_count;
      for (std::size_t k = 0; k < scores.size(); ++k) {
        EXPECT_EQ(scores[k].column, expected[k].column);
        EXPECT_EQ(scores[k].row, expected[k].row);
        EXPECT_EQ(scores[k].count, expected[k].count);
      }
    }
  }
}

TEST(ScoreKernel, LeavesOutExactlyTheTranslationsThatDoNotReachTheMinimum) {
  const ScoreKernel kernel;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem(seed);
    const PooledLevel& level = problem.grids[0].level(1);
    std::vector<TileScore> all;
    kernel.scoreTile(level, problem.cells, problem.first, {}, 0, all);
    std::int32_t best = 0;
    for (const TileScore& score : all) {
      best = std::max(best, score.count);
    }
    for (const std::int32_t min_count : {best / 2, best, best + 1, best + 1000000}) {
      std::vector<TileScore> expected;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                   [min_count](const TileScore& score) { return score.count >= min_count; });
      std::vector<TileScore> scores;

      kernel.scoreTile(level, problem.cells, problem.first, {}, min_count, scores);

      ASSERT_EQ(scores.size(), expected.size()) << "min_count " << min_count;
      for (std::size_t k = 0; k < scores.size(); ++k) {
        EXPECT_EQ(scores[k].count, expected[k].count);
      }
    }
  }
}

}  // namespace
}  // namespace map_matcher::search
