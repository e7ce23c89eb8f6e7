#include <gtest/gtest.h>

#include "map_matcher/grid/seen_space.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::grid {
namespace {

TEST(SeenSpace, TellsWallsFreeSpaceAndWhatWasNeverSeen) {
  const SeenSpace space(test::asciiMap({"#....????"}, 0.1), 0.0, kDefaultOccupiedThreshold);

  EXPECT_EQ(space.at({0.05, 0.05}), Seen::kNearWall);
  EXPECT_EQ(space.at({0.25, 0.05}), Seen::kNearWall) << "0.2 m from the middle of the wall";
  EXPECT_EQ(space.at({0.35, 0.05}), Seen::kOpen);
  EXPECT_EQ(space.at({0.75, 0.05}), Seen::kUnseen);
  EXPECT_EQ(space.at({-0.05, 0.05}), Seen::kUnseen) << "beyond the map";
}

TEST(SeenSpace, IsNotSureOfWhatIsNeitherFreeNorAWall) {
  OccupancyGrid map({0.1, 3, 1, {}});
  map.at(0, 0) = 35;
  map.at(1, 0) = 36;
  map.at(2, 0) = 64;
  const SeenSpace space(map, 0.0, 65);

  EXPECT_EQ(space.at({0.05, 0.05}), Seen::kOpen);
  EXPECT_EQ(space.at({0.15, 0.05}), Seen::kUnseen);
  EXPECT_EQ(space.at({0.25, 0.05}), Seen::kUnseen);
}

TEST(SeenSpace, CountsAThickWallOnce) {
  const SeenSpace thin(test::asciiMap({".......", "#######", "......."}, 0.1), 0.0, kDefaultOccupiedThreshold);
  const SeenSpace thick(test::asciiMap({".......", "#######", "#######", "#######", "......."}, 0.1), 0.0,
                        kDefaultOccupiedThreshold);

  EXPECT_EQ(thin.walls().size(), 7U);
  ASSERT_EQ(thick.walls().size(), 7U) << "its middle line";
  for (const Eigen::Vector2d& wall : thick.walls()) {
    EXPECT_DOUBLE_EQ(wall.y(), 0.25);
  }
}

TEST(SeenSpace, TakesTheCellOffsetOff) {
  const SeenSpace space(test::asciiMap({"#."}, 0.1), 0.5, kDefaultOccupiedThreshold);

  ASSERT_EQ(space.walls().size(), 1U);
  EXPECT_NEAR(space.walls().front().x(), 0.0, 1e-12);
}

}  // namespace
}  // namespace map_matcher::grid
