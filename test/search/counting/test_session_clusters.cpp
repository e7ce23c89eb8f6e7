#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "map_matcher/search/counting/session_clusters.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

SessionCells sessionOf(const std::vector<grid::Cell>& cells) {
  return prepareSessionCells(cells, 0.05, 0.05, CellMerging::kNone, 0);
}

/// A wall along x of `length` cells.
std::vector<grid::Cell> wall(int length) {
  std::vector<grid::Cell> cells;
  for (int x = 0; x < length; ++x) {
    cells.push_back({x, 0});
  }
  return cells;
}

std::int32_t sumOfWeights(const SessionClusters& clusters) {
  std::int32_t sum = 0;
  for (const WeightedCells::Run& run : clusters.runs) {
    sum += static_cast<std::int32_t>(run.size) * run.weight;
  }
  return sum;
}

TEST(SessionClusters, CountEveryCellOnceAtEveryLevel) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const int size = test::randomInt(random, 1, 200);
    const std::vector<grid::Cell> cells = test::randomCells(random, size, size, test::randomInt(random, 1, 900));
    for (int level = 1; level <= BlockShape::kMaxLevel; ++level) {
      const SessionCells session = sessionOf(cells);

      const SessionClusters clusters = clustersOf(session, BlockShape{level});

      EXPECT_EQ(clusters.total, static_cast<std::int32_t>(session.points.size()));
      EXPECT_EQ(sumOfWeights(clusters), clusters.total);
      EXPECT_EQ(clusters.x.size(), clusters.y.size());
      for (std::size_t run = 1; run < clusters.runs.size(); ++run) {
        EXPECT_LT(clusters.runs[run].weight, clusters.runs[run - 1].weight);
      }
    }
  }
}

TEST(SessionClusters, OfAWallAreFewerWhereItTurnsLess) {
  const SessionClusters clusters = clustersOf(sessionOf(wall(1000)), BlockShape{4});

  std::set<float> near;
  std::set<float> far;
  for (const float x : clusters.x) {
    if (std::abs(x) < 100.0F) {
      near.insert(x);
    } else if (std::abs(x) >= 400.0F) {
      far.insert(x);
    }
  }
  EXPECT_LT(near.size(), 40U);  // of 200 cells
  EXPECT_LT(near.size(), far.size());
  EXPECT_LT(far.size(), 200U);
}

TEST(SessionClusters, OfASingleCellIsItself) {
  const SessionClusters clusters = clustersOf(sessionOf({{7, 3}}), BlockShape{3});

  ASSERT_EQ(clusters.x.size(), 1U);
  EXPECT_EQ(clusters.x[0], 0.0F);
  EXPECT_EQ(clusters.total, 1);
}

}  // namespace
}  // namespace map_matcher::search
