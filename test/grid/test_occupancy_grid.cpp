#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::grid {
namespace {

using test::asciiMap;

std::string messageOf(const GridGeometry& geometry, const std::vector<std::int8_t>& values) {
  try {
    const OccupancyGrid grid(geometry, values);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(OccupancyGrid, IsUnknownWhereNothingWasWritten) {
  const OccupancyGrid grid(GridGeometry{0.05, 3, 2, {}});

  EXPECT_EQ(grid.values(), std::vector<std::int8_t>(6, kUnknown));
}

TEST(OccupancyGrid, IsRowMajorFromTheLowerLeft) {
  const OccupancyGrid grid(GridGeometry{0.05, 3, 2, {}}, {0, 1, 2, 3, 4, 5});

  EXPECT_EQ(grid.at(0, 0), 0);
  EXPECT_EQ(grid.at(2, 0), 2);
  EXPECT_EQ(grid.at(0, 1), 3);
  EXPECT_EQ(grid.at(2, 1), 5);
}

TEST(OccupancyGrid, HoldsWhatIsWritten) {
  OccupancyGrid grid(GridGeometry{0.05, 3, 2, {}});

  grid.at(1, 1) = kOccupied;

  EXPECT_EQ(grid.values(), (std::vector<std::int8_t>{-1, -1, -1, -1, 100, -1}));
}

TEST(OccupancyGrid, RefusesANumberOfValuesOtherThanItsCells) {
  const std::string message = messageOf({0.05, 3, 2, {}}, {0, 0, 0, 0, 0});

  EXPECT_NE(message.find("5 values"), std::string::npos) << message;
  EXPECT_NE(message.find("3 x 2 = 6"), std::string::npos) << message;
}

TEST(OccupancyGrid, RefusesValuesThatAreNoOccupancy) {
  EXPECT_EQ(messageOf({1.0, 2, 1, {}}, {-1, 100}), "");
  EXPECT_NE(messageOf({1.0, 2, 1, {}}, {0, 101}).find("value 101 at index 1"), std::string::npos);
  EXPECT_NE(messageOf({1.0, 2, 1, {}}, {-2, 0}).find("value -2 at index 0"), std::string::npos);
}

TEST(OccupancyGrid, RefusesABadGeometry) {
  EXPECT_THROW(OccupancyGrid(GridGeometry{0.0, 1, 1, {}}), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(GridGeometry{1.0, 0, 1, {}}), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(GridGeometry{1.0, 0, 0, {}}, {}), std::invalid_argument);
}

TEST(AsciiMap, DrawsTheTopRowFirst) {
  const OccupancyGrid grid = asciiMap({"#?.",  //
                                       ".#"});

  EXPECT_EQ(grid.at(0, 1), kOccupied);
  EXPECT_EQ(grid.at(1, 1), kUnknown);
  EXPECT_EQ(grid.at(0, 0), kFree);
  EXPECT_EQ(grid.at(2, 0), kUnknown) << "a short row ends in unknown cells";
  EXPECT_EQ(test::drawingOf(grid), (std::vector<std::string>{"#?.", ".#?"}));
}

}  // namespace
}  // namespace map_matcher::grid
