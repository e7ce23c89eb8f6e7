#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/grid/resample.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::grid {
namespace {

using test::asciiMap;
using test::drawingOf;
using Drawing = std::vector<std::string>;

TEST(Resample, KeepsTheGridAtItsOwnResolution) {
  const OccupancyGrid grid = asciiMap({"#.?", "?#."}, 0.05);

  const OccupancyGrid same = resample(grid, 0.05);

  EXPECT_EQ(same.values(), grid.values());
}

TEST(Resample, TakesTheLargestValueWhenItHalves) {
  const OccupancyGrid grid = asciiMap({"...???",  //
                                       ".#.???",  //
                                       "....??",  //
                                       "....??"},
                                      0.05);

  EXPECT_EQ(drawingOf(resample(grid, 0.1)), (Drawing{"#.?",  //
                                                     "..?"}));
}

TEST(Resample, CoversACellThatIsOnlyPartlyInside) {
  const OccupancyGrid grid = asciiMap({"....#",  //
                                       ".....",  //
                                       "....."},
                                      0.05);

  const OccupancyGrid coarse = resample(grid, 0.1);

  EXPECT_EQ(drawingOf(coarse), (Drawing{"..#",  //
                                        "..."}));
}

TEST(Resample, RepeatsEachCellWhenItRefines) {
  EXPECT_EQ(drawingOf(resample(asciiMap({"#?", "?."}, 0.1), 0.05)), (Drawing{"##??",  //
                                                                             "##??",  //
                                                                             "??..",  //
                                                                             "??.."}));
}

TEST(Resample, GivesAWallToEveryCellItReachesInto) {
  // Cells of 0.075 over cells of 0.05: the wall from 0.05 to 0.1 reaches into the first two.
  EXPECT_EQ(drawingOf(resample(asciiMap({".#...."}, 0.05), 0.075)), (Drawing{"##.."}));
}

TEST(Resample, KeepsTheOriginWithItsYaw) {
  const Rigid2 origin{1.5, -2.5, 0.3};

  const GridGeometry geometry = resample(asciiMap({"#..", "..."}, 0.05, origin), 0.1).geometry();

  EXPECT_EQ(geometry.T_map_grid.x, origin.x);
  EXPECT_EQ(geometry.T_map_grid.y, origin.y);
  EXPECT_EQ(geometry.T_map_grid.yaw, origin.yaw);
  EXPECT_EQ(geometry.resolution, 0.1);
}

TEST(Resample, NeedsAResolutionThatMakesAGrid) {
  const OccupancyGrid grid = asciiMap({"#"}, 0.05);
  for (const double resolution :
       {0.0, -0.05, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e-12, 1e-7}) {
    EXPECT_THROW(resample(grid, resolution), std::invalid_argument) << resolution;
  }
}

TEST(Resample, ShrinksToOneCellForAnyLargeResolution) {
  const OccupancyGrid grid = asciiMap({"..", ".#"}, 0.05);
  for (const double resolution : {0.1, 1.0, 1e6, 1e300}) {
    EXPECT_EQ(drawingOf(resample(grid, resolution)), (Drawing{"#"})) << resolution;
  }
}

TEST(Resample, LosesNoWallOfALongGridToRounding) {
  constexpr int kLength = 2000001;  // one cell more than a coarse cell holds: 5e-7 of it
  OccupancyGrid grid(GridGeometry{1.0, kLength, 1, {}});
  grid.at(kLength - 1, 0) = kOccupied;

  EXPECT_EQ(occupiedCells(resample(grid, kLength - 1.0)).size(), 1U);
}

/// Laws for grids and resolutions drawn by a seed.
class ResampleProperty : public testing::TestWithParam<unsigned> {
 protected:
  std::mt19937 random_{GetParam()};
  OccupancyGrid grid_ = randomGrid();
  double resolution_ = randomResolution();
  OccupancyGrid resampled_ = resample(grid_, resolution_);

  /// Whether the new cell `index` and the old cell `old_index` of one axis share more than their edges.
  bool overlap(int index, int old_index) const {
    const double low = std::max(index * resolution_, old_index * grid_.resolution());
    const double high = std::min((index + 1) * resolution_, (old_index + 1) * grid_.resolution());
    return high - low > 1e-5 * grid_.resolution();
  }

 private:
  OccupancyGrid randomGrid() {
    std::uniform_int_distribution<int> size(1, 24);
    OccupancyGrid grid(GridGeometry{0.05, size(random_), size(random_), {}});
    std::discrete_distribution<int> kind({6, 2, 1, 1});
    const std::int8_t values[] = {kUnknown, kFree, 40, kOccupied};
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        grid.at(x, y) = values[kind(random_)];
      }
    }
    return grid;
  }

  double randomResolution() {
    const double usual[] = {0.01, 0.02, 0.025, 0.05, 0.1, 0.15, 0.2, 0.4, 1.6};
    std::uniform_int_distribution<int> which(0, 17);
    const int index = which(random_);
    return index < 9 ? usual[index] : std::uniform_real_distribution<double>(0.008, 0.5)(random_);
  }
};

TEST_P(ResampleProperty, EachCellHoldsTheLargestValueOfWhatItOverlaps) {
  for (int y = 0; y < resampled_.height(); ++y) {
    for (int x = 0; x < resampled_.width(); ++x) {
      std::int8_t largest = kUnknown;
      for (int old_y = 0; old_y < grid_.height(); ++old_y) {
        for (int old_x = 0; old_x < grid_.width(); ++old_x) {
          if (overlap(x, old_x) && overlap(y, old_y)) {
            largest = std::max(largest, grid_.at(old_x, old_y));
          }
        }
      }
      EXPECT_EQ(resampled_.at(x, y), largest)
          << "cell " << x << ", " << y << " at " << resolution_ << " m, seed " << GetParam();
    }
  }
}

TEST_P(ResampleProperty, TheCentreOfEveryWallStaysAWall) {
  for (const Cell& wall : occupiedCells(grid_)) {
    const Cell cell = resampled_.geometry().cellAt(grid_.geometry().cellCentre(wall));
    ASSERT_TRUE(resampled_.geometry().contains(cell)) << "at " << resolution_ << " m, seed " << GetParam();
    EXPECT_EQ(resampled_.at(cell.x, cell.y), kOccupied) << "at " << resolution_ << " m, seed " << GetParam();
  }
}

TEST_P(ResampleProperty, TheGridIsCoveredWithLessThanACellToSpare) {
  const double width = grid_.width() * grid_.resolution();
  EXPECT_GE(resampled_.width() * resolution_, width - 1e-6);
  EXPECT_LT((resampled_.width() - 1) * resolution_, width);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ResampleProperty, testing::Range(1U, 101U));

}  // namespace
}  // namespace map_matcher::grid
