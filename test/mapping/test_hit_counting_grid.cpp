#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "map_matcher/mapping/hit_counting_grid.hpp"

namespace map_matcher::mapping {
namespace {

constexpr double kThreshold = 0.25;

/// The values of a grid, upper row first: '#' occupied, '.' free, '?' unknown.
std::vector<std::string> picture(const grid::OccupancyGrid& grid) {
  std::vector<std::string> rows;
  for (int y = grid.height() - 1; y >= 0; --y) {
    std::string row;
    for (int x = 0; x < grid.width(); ++x) {
      row += grid.at(x, y) == grid::kUnknown ? '?' : (grid.at(x, y) == grid::kOccupied ? '#' : '.');
    }
    rows.push_back(row);
  }
  return rows;
}

/// A grid of 1 m cells that covers (0, 0) to (5, 3).
HitCountingGrid smallGrid() { return HitCountingGrid(1.0, {{0.0, 0.0}, {5.0, 3.0}}); }

int at(const grid::OccupancyGrid& grid, const Eigen::Vector2d& point) {
  const grid::Cell cell = grid.geometry().cellAt(point);
  return grid.at(cell.x, cell.y);
}

TEST(HitCountingGrid, IsUnknownBeforeTheFirstBeam) {
  EXPECT_EQ(picture(smallGrid().toOccupancyGrid(kThreshold)), (std::vector<std::string>{"?????", "?????", "?????"}));
}

TEST(HitCountingGrid, DrawsABeamFreeUpToTheWallAtItsEnd) {
  HitCountingGrid grid = smallGrid();

  grid.draw({{0.5, 1.5}, {{{3.5, 1.5}, true}}});

  EXPECT_EQ(picture(grid.toOccupancyGrid(kThreshold)), (std::vector<std::string>{"?????", "...#?", "?????"}));
}

TEST(HitCountingGrid, DrawsABeamWithoutAHitFree) {
  HitCountingGrid grid = smallGrid();

  grid.draw({{0.5, 1.5}, {{{3.5, 1.5}, false}}});

  EXPECT_EQ(picture(grid.toOccupancyGrid(kThreshold)), (std::vector<std::string>{"?????", "....?", "?????"}));
}

TEST(HitCountingGrid, VisitsEveryCellThatASlantedBeamCrosses) {
  HitCountingGrid grid = smallGrid();

  grid.draw({{0.5, 0.5}, {{{4.5, 2.6}, true}}});  // y = 1 at x = 1.45, y = 2 at x = 3.36

  EXPECT_EQ(picture(grid.toOccupancyGrid(kThreshold)), (std::vector<std::string>{"???.#", "?...?", "..???"}));
}

TEST(HitCountingGrid, DrawsTheSameCellsInAllEightDirections) {
  const std::vector<Eigen::Vector2d> ends = {{4.5, 2.6},   {2.6, 4.5},   {-2.6, 4.5}, {-4.5, 2.6},
                                             {-4.5, -2.6}, {-2.6, -4.5}, {2.6, -4.5}, {4.5, -2.6}};
  for (const Eigen::Vector2d& end : ends) {
    HitCountingGrid grid(1.0, {{-6.0, -6.0}, {6.0, 6.0}});
    const Eigen::Vector2d origin(std::copysign(0.5, end.x()), std::copysign(0.5, end.y()));

    grid.draw({origin, {{end, true}}});

    const grid::OccupancyGrid map = grid.toOccupancyGrid(kThreshold);
    int free = 0;
    int occupied = 0;
    for (const std::int8_t value : map.values()) {
      free += value == grid::kFree ? 1 : 0;
      occupied += value == grid::kOccupied ? 1 : 0;
    }
    EXPECT_EQ(free, 6) << end.transpose();
    EXPECT_EQ(occupied, 1) << end.transpose();
    EXPECT_EQ(at(map, end), grid::kOccupied) << end.transpose();
  }
}

TEST(HitCountingGrid, CallsACellAWallWhenMoreThanTheThresholdOfItsBeamsEndedThere) {
  HitCountingGrid grid = smallGrid();
  const Beam hit{{2.5, 1.5}, true};
  const Beam pass{{4.5, 1.5}, false};

  grid.draw({{0.5, 1.5}, {hit, pass, pass, pass}});
  EXPECT_EQ(at(grid.toOccupancyGrid(kThreshold), {2.5, 1.5}), grid::kFree) << "1 of 4 is not more than 0.25";

  grid.draw({{0.5, 1.5}, {hit}});
  EXPECT_EQ(at(grid.toOccupancyGrid(kThreshold), {2.5, 1.5}), grid::kOccupied) << "2 of 5 is more than 0.25";
}

TEST(HitCountingGrid, KeepsTheShareOfHitsWhenItsCountersAreFull) {
  HitCountingGrid grid = smallGrid();
  const std::vector<Beam> beams = {{{2.5, 1.5}, true}, {{4.5, 1.5}, false}};

  for (int i = 0; i < 100'000; ++i) {
    grid.draw({{0.5, 1.5}, beams});
  }

  EXPECT_EQ(at(grid.toOccupancyGrid(0.49), {2.5, 1.5}), grid::kOccupied);
  EXPECT_EQ(at(grid.toOccupancyGrid(0.51), {2.5, 1.5}), grid::kFree);
}

TEST(HitCountingGrid, ChangesFromCellToCellExactlyAtMultiplesOfTheResolution) {
  for (const double resolution : {0.02, 0.05, 0.1, 0.3}) {
    for (int line = -40; line <= 40; ++line) {
      HitCountingGrid grid(resolution, {{-1.0, -1.0}, {1.0, 1.0}});
      const double below = (line - 0.01) * resolution;
      const double above = (line + 0.01) * resolution;

      grid.draw({{below, 0.5 * resolution}, {{{below, 0.5 * resolution}, true}}});

      const grid::OccupancyGrid map = grid.toOccupancyGrid(kThreshold);
      EXPECT_EQ(at(map, {below, 0.5 * resolution}), grid::kOccupied) << line << " x " << resolution;
      EXPECT_EQ(at(map, {above, 0.5 * resolution}), grid::kUnknown) << line << " x " << resolution;
    }
  }
}

TEST(HitCountingGrid, GrowsToAllSidesByMultiplesOf32CellsAndKeepsWhatItHas) {
  HitCountingGrid grid = smallGrid();
  grid.draw({{0.5, 1.5}, {{{3.5, 1.5}, true}}});

  ASSERT_TRUE(grid.draw({{-3.5, -3.5}, {{{40.5, 50.5}, true}}}));

  const grid::OccupancyGrid map = grid.toOccupancyGrid(kThreshold);
  EXPECT_EQ(map.width(), 5 + 32 + 64);
  EXPECT_EQ(map.height(), 3 + 32 + 64);
  EXPECT_DOUBLE_EQ(map.geometry().T_map_grid.x, -32.0);
  EXPECT_DOUBLE_EQ(map.geometry().T_map_grid.y, -32.0);
  EXPECT_EQ(at(map, {3.5, 1.5}), grid::kOccupied);
  EXPECT_EQ(at(map, {1.5, 1.5}), grid::kFree);
  EXPECT_EQ(at(map, {40.5, 50.5}), grid::kOccupied);
}

TEST(HitCountingGrid, RefusesToGrowBeyondItsLimitAndStaysAsItIs) {
  HitCountingGrid grid = smallGrid();
  grid.draw({{0.5, 1.5}, {{{3.5, 1.5}, true}}});

  EXPECT_FALSE(grid.draw({{0.5, 1.5}, {{{2e4, 2e4}, true}}}));
  EXPECT_FALSE(grid.draw({{0.5, 1.5}, {{{1e300, -1e300}, true}}}));

  EXPECT_EQ(picture(grid.toOccupancyGrid(kThreshold)), (std::vector<std::string>{"?????", "...#?", "?????"}));
}

TEST(HitCountingGrid, RefusesABadResolutionOrExtent) {
  EXPECT_THROW(HitCountingGrid(0.0, {{0.0, 0.0}, {1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW(HitCountingGrid(std::nan(""), {{0.0, 0.0}, {1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW(HitCountingGrid(0.05, {{1.0, 0.0}, {1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW(HitCountingGrid(0.05, {{0.0, std::nan("")}, {1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW(HitCountingGrid(0.001, {{0.0, 0.0}, {1e5, 1e5}}), std::invalid_argument);
}

TEST(HitCountingGrid, CoversItsExtentInWholeCells) {
  const grid::OccupancyGrid map = HitCountingGrid(0.05, {{-10.0, -10.0}, {10.0, 10.0}}).toOccupancyGrid(kThreshold);
  EXPECT_EQ(map.width(), 400);
  EXPECT_EQ(map.height(), 400);
  EXPECT_DOUBLE_EQ(map.geometry().T_map_grid.x, -10.0);
  EXPECT_DOUBLE_EQ(map.geometry().T_map_grid.yaw, 0.0);
}

TEST(HitCountingGrid, KnowsWhereInItsCellAWallIs) {
  HitCountingGrid grid = smallGrid();
  grid.draw({{0.5, 1.5}, {{{3.2, 1.6}, true}, {{3.3, 1.6}, true}, {{3.4, 1.6}, true}}});

  const std::vector<WallPoint> walls = grid.wallsIn({{0.0, 0.0}, {5.0, 3.0}}, kThreshold);

  ASSERT_EQ(walls.size(), 1U);
  EXPECT_EQ(walls.front().hits, 3);
  EXPECT_NEAR(walls.front().position.x(), 3.3, 1e-3);
  EXPECT_NEAR(walls.front().position.y(), 1.6, 1e-3);
  EXPECT_TRUE(grid.wallsIn({{0.0, 0.0}, {2.9, 3.0}}, kThreshold).empty());
  EXPECT_EQ(grid.wallsIn({{-100.0, -100.0}, {100.0, 100.0}}, kThreshold).size(), 1U);
}

TEST(HitCountingGrid, KnowsWhereNoBeamCame) {
  HitCountingGrid grid = smallGrid();
  grid.draw({{0.5, 1.5}, {{{3.5, 1.5}, true}}});

  EXPECT_TRUE(grid.isKnown({2.2, 1.1}));
  EXPECT_FALSE(grid.isKnown({4.5, 1.5}));
  EXPECT_FALSE(grid.isKnown({-50.0, 1.5}));
}

TEST(HitCountingGrid, TellsHowManyBeamsGoThroughWalls) {
  HitCountingGrid grid = smallGrid();
  grid.draw({{0.5, 1.5}, {{{2.5, 1.5}, true}}});
  const Beam through{{4.5, 1.5}, true};
  const Beam up_to_it{{2.4, 1.5}, true};
  const Beam a_bit_behind{{3.2, 1.5}, true};
  const Beam beside{{4.5, 2.5}, true};

  EXPECT_EQ(grid.shareThroughWalls({{0.5, 1.5}, {through, up_to_it, a_bit_behind}}, kThreshold, 1.3), 1.0 / 3.0);
  EXPECT_EQ(grid.shareThroughWalls({{0.5, 2.5}, {beside}}, kThreshold, 1.3), 0.0);
  EXPECT_EQ(grid.shareThroughWalls({{0.5, 2.5}, {}}, kThreshold, 1.3), 0.0);
}

TEST(HitCountingGrid, TakesNoLongerOverABeamThatEndsFarBeyondIt) {
  HitCountingGrid grid = smallGrid();
  grid.draw({{0.5, 1.5}, {{{2.5, 1.5}, true}}});
  const Eigen::Vector2d behind = Eigen::Vector2d(1e8, 2e4);
  const Eigen::Vector2d beside = Eigen::Vector2d(1e8, 2e8);
  BeamFan fan{{0.5, 1.5}, {}};
  for (int k = 0; k < 500; ++k) {  // to walk along them takes minutes
    fan.beams.insert(fan.beams.end(), {{behind, true}, {beside, true}});
  }

  EXPECT_EQ(grid.shareThroughWalls(fan, kThreshold, 1.3), 0.5);
  EXPECT_EQ(grid.shareThroughWalls({{1e9, 1.5}, {{{-1e9, 1.5}, true}}}, kThreshold, 1.3), 1.0);
  EXPECT_EQ(grid.shareThroughWalls({{-1e300, 7.0}, {{{1e300, 7.0}, true}}}, kThreshold, 1.3), 0.0);
}

}  // namespace
}  // namespace map_matcher::mapping
