#include <gtest/gtest.h>

#include <random>

#include "map_matcher/search/counting/search_window.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

TEST(SearchWindow, HoldsEveryTranslationThatCanMatchEnough) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const PrecomputedGrids reference(30, 20, test::randomCells(random, 30, 20, 40), 0);
    const RotatedCells cells = test::randomRotatedCells(random, 15, 12);
    const int min_matches = test::randomInt(random, 1, 12);

    const SearchWindow window = reachableWindow(reference, cells, min_matches);

    for (int y = -50; y < 70; ++y) {
      for (int x = -50; x < 80; ++x) {
        const bool inside = x >= window.first.x && x <= window.last.x && y >= window.first.y && y <= window.last.y;
        if (!inside) {
          ASSERT_LT(test::countMatches(reference.level(0), cells, {x, y}), min_matches) << x << ", " << y;
        }
      }
    }
  }
}

TEST(SearchWindow, HoldsEveryTranslationThatCanMatchEnoughNearTheWalls) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const PrecomputedGrids reference(30, 20, test::randomCells(random, 30, 20, 40), 0, 0);
    const RotatedCells cells = test::randomRotatedCells(random, 15, 12);
    const int min_matches = test::randomInt(random, 1, 12);

    const SearchWindow window = reachableWindow(reference, cells, min_matches, kBandReach);

    for (int y = -50; y < 70; ++y) {
      for (int x = -50; x < 80; ++x) {
        const bool inside = x >= window.first.x && x <= window.last.x && y >= window.first.y && y <= window.last.y;
        if (!inside) {
          const grid::Cell position = PrecomputedGrids::bandPosition({x, y});
          ASSERT_LT(test::countMatches(reference.bandLevel(0), cells, position), min_matches) << x << ", " << y;
        }
      }
    }
  }
}

TEST(SearchWindow, ForEveryCellIsNoLargerThanTheWalls) {
  const PrecomputedGrids reference(10, 10, {{2, 3}, {6, 3}, {2, 8}}, 0);
  RotatedCells cells;
  cells.x = {-1, 1};
  cells.y = {0, 0};

  const SearchWindow window = reachableWindow(reference, cells, 2);

  EXPECT_EQ(window.first, (grid::Cell{3, 3}));
  EXPECT_EQ(window.last, (grid::Cell{5, 8}));
}

TEST(SearchWindow, OfCellsWiderThanTheWallsIsEmpty) {
  const PrecomputedGrids reference(10, 10, {{4, 4}}, 0);
  RotatedCells cells;
  cells.x = {-3, 3};
  cells.y = {0, 0};

  EXPECT_TRUE(reachableWindow(reference, cells, 2).empty());
}

TEST(SearchWindow, IntersectionIsWhatBothHold) {
  const SearchWindow window = intersection({{0, 0}, {5, 5}}, {{2, -3}, {9, 4}});

  EXPECT_EQ(window.first, (grid::Cell{2, 0}));
  EXPECT_EQ(window.last, (grid::Cell{5, 4}));
}

}  // namespace
}  // namespace map_matcher::search
