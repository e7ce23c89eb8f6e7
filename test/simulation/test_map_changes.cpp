#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/simulation/map_changes.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::simulation {
namespace {

using test::asciiMap;
using test::drawingOf;

TEST(MapChanges, leaveAPartUnknownWithAllThatIsInIt) {
  const grid::OccupancyGrid map = asciiMap({"####",  //
                                            "#..#",  //
                                            "####"});

  const grid::OccupancyGrid without = withoutPart(map, {1.9, 0.0, 4.0, 1.9});

  EXPECT_EQ(drawingOf(without), (std::vector<std::string>{"####", "#.??", "##??"}));
}

TEST(MapChanges, takeThePartInTheFrameOfAMapThatIsTurned) {
  const grid::OccupancyGrid map = asciiMap({"##",  //
                                            ".."},
                                           1.0, {10.0, 0.0, 0.5 * M_PI});

  const grid::OccupancyGrid without = withoutPart(map, {8.0, 0.0, 9.0, 1.0});  // where the upper left cell lies

  EXPECT_EQ(drawingOf(without), (std::vector<std::string>{"?#", ".."}));
}

}  // namespace
}  // namespace map_matcher::simulation
