#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/evaluation/map_quality.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::evaluation {
namespace {

grid::OccupancyGrid trueMap() {
  return test::asciiMap({"########??",  //
                         "#......#??",  //
                         "#......#??",  //
                         "########??"},
                        0.1);
}

TEST(MapQuality, TellsWallsFromWhatStandsInFreeSpace) {
  const grid::OccupancyGrid session = test::asciiMap({"#.......#?",  //
                                                      "#.......??",  //
                                                      "#..#....??",  //
                                                      "########??"},
                                                     0.1);

  const MapQuality quality = mapQuality(trueMap(), session, {}, 0.0);

  EXPECT_EQ(quality.occupied, 13);
  EXPECT_EQ(quality.on_walls, 11);
  EXPECT_EQ(quality.falsely_occupied, 1);
  EXPECT_EQ(quality.unknown, 1);
}

TEST(MapQuality, ForgivesWhatIsWithinTheTolerance) {
  const grid::OccupancyGrid session = test::asciiMap({"..........", ".#........", "...#......", ".........."}, 0.1);

  EXPECT_EQ(mapQuality(trueMap(), session, {}, 0.05).falsely_occupied, 2);
  EXPECT_EQ(mapQuality(trueMap(), session, {}, 0.1).falsely_occupied, 0);
}

TEST(MapQuality, PlacesTheSessionMapAtItsPose) {
  const grid::OccupancyGrid session = test::asciiMap({"#"}, 0.1);  // a cell with its centre at (0.05, 0.05)

  EXPECT_EQ(mapQuality(trueMap(), session, {0.3, 0.2, 0.0}, 0.0).falsely_occupied, 1);
  EXPECT_EQ(mapQuality(trueMap(), session, {0.4, 0.0, M_PI_2}, 0.0).on_walls, 1);
  EXPECT_EQ(mapQuality(trueMap(), session, {-3.0, 0.0, 0.0}, 0.0).unknown, 1);
}

}  // namespace
}  // namespace map_matcher::evaluation
