#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "map_matcher/grid/occupied_cells.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::grid {
namespace {

using test::asciiMap;

TEST(OccupiedCells, AreListedRowByRowFromTheLowerLeft) {
  const OccupancyGrid grid = asciiMap({"..#?",  //
                                       "?...",  //
                                       "#..#"});

  EXPECT_EQ(occupiedCells(grid), (std::vector<Cell>{{0, 0}, {3, 0}, {2, 2}}));
}

TEST(OccupiedCells, AreThoseFromTheThresholdOn) {
  const OccupancyGrid grid(GridGeometry{1.0, 6, 1, {}}, {-1, 0, 49, 50, 64, 65});

  EXPECT_EQ(occupiedCells(grid), (std::vector<Cell>{{5, 0}}));
  EXPECT_EQ(occupiedCells(grid, 50), (std::vector<Cell>{{3, 0}, {4, 0}, {5, 0}}));
}

TEST(OccupiedCells, AreNeverUnknownOnes) {
  const OccupancyGrid grid = asciiMap({"???", "???"});

  EXPECT_TRUE(occupiedCells(grid, 1).empty());
}

TEST(OccupiedCells, AreAllOfAFullGrid) {
  const OccupancyGrid grid = asciiMap({"###", "###"});

  EXPECT_EQ(occupiedCells(grid, 100).size(), 6U);
}

TEST(OccupiedCells, NeedAThresholdThatFreeAndUnknownCellsStayBelow) {
  const OccupancyGrid grid = asciiMap({"#"});

  EXPECT_THROW(occupiedCells(grid, 0), std::invalid_argument);
  EXPECT_THROW(occupiedCells(grid, -1), std::invalid_argument);
  EXPECT_THROW(occupiedCells(grid, 101), std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher::grid
