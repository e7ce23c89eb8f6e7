#include <gtest/gtest.h>

#include <map>
#include <random>

#include "map_matcher/search/weighted_cells.hpp"
#include "support/random_maps.hpp"

namespace map_matcher {
namespace {

using Weights = std::map<std::pair<int, int>, std::int32_t>;  // by x and y

Weights weightsOf(const WeightedCells& cells) {
  Weights weights;
  std::size_t k = 0;
  for (const WeightedCells::Run& run : cells.runs) {
    for (const std::size_t end = k + run.size; k < end; ++k) {
      EXPECT_TRUE(weights.emplace(std::make_pair(cells.cells.x[k], cells.cells.y[k]), run.weight).second);
    }
  }
  EXPECT_EQ(k, cells.cells.x.size());
  return weights;
}

TEST(CellMerger, PutsTheCellsOfABlockTogetherAtItsLowerLeftCorner) {
  CellMerger merger;

  const WeightedCells merged = merger.merge({{0, 3, 4, -1, -4}, {0, 3, 4, -1, -1}}, 4);

  EXPECT_EQ(weightsOf(merged), (Weights{{{0, 0}, 2}, {{4, 4}, 1}, {{-4, -4}, 2}}));
  EXPECT_EQ(merged.total, 5);
}

TEST(CellMerger, BlocksOfOneCellKeepEveryCell) {
  CellMerger merger;
  const RotatedCells cells{{7, 7, -3}, {1, 1, 2}};

  const WeightedCells merged = merger.merge(cells, 1);

  EXPECT_EQ(merged.cells.x, cells.x);
  EXPECT_EQ(merged.cells.y, cells.y);
  ASSERT_EQ(merged.runs.size(), 1U);
  EXPECT_EQ(merged.runs[0].size, 3U);
  EXPECT_EQ(merged.runs[0].weight, 1);
}

TEST(CellMerger, LeavesCellsVeryFarApartAsTheyAre) {
  CellMerger merger;
  const RotatedCells cells{{-15000, 15000, 15000}, {-15000, 15000, 15001}};

  const WeightedCells merged = merger.merge(cells, 2);

  EXPECT_EQ(merged.cells.x, cells.x);
  EXPECT_EQ(merged.cells.y, cells.y);
  EXPECT_EQ(merged.total, 3);
}

TEST(CellMerger, CountsAsOneByOneInCallsOfAnySize) {
  CellMerger merger;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const int block = 1 << test::randomInt(random, 1, 5);
    const RotatedCells cells =
        test::randomRotatedCells(random, test::randomInt(random, 1, 3000), test::randomInt(random, 1, 3000));
    Weights expected;
    for (std::size_t k = 0; k < cells.x.size(); ++k) {
      const auto lower = [block](int value) { return static_cast<int>(std::floor(1.0 * value / block)) * block; };
      ++expected[{lower(cells.x[k]), lower(cells.y[k])}];
    }

    const WeightedCells merged = merger.merge(cells, block);

    EXPECT_EQ(weightsOf(merged), expected);
    EXPECT_EQ(merged.total, static_cast<std::int32_t>(cells.x.size()));
    for (std::size_t run = 1; run < merged.runs.size(); ++run) {
      EXPECT_LT(merged.runs[run].weight, merged.runs[run - 1].weight);
    }
  }
}

}  // namespace
}  // namespace map_matcher
