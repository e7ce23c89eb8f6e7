#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <tuple>

#include "map_matcher/evaluation/map_changes.hpp"
#include "support/ascii_map.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher::evaluation {
namespace {

/// A room with a cupboard (the two cells inside), and a part that was never seen.
grid::OccupancyGrid before() {
  return test::asciiMap({"########??",  //
                         "#......#??",  //
                         "#.##...#??",  //
                         "########??"},
                        0.5);
}

/// The cupboard is gone, something new stands at the right, the top was not seen, and a wall behind the room was.
grid::OccupancyGrid after() {
  return test::asciiMap({"??????????",  //
                         "#.....##.#",  //
                         "#......#.#",  //
                         "########.#"},
                        0.5);
}

TEST(MapChanges, TellsWhatIsGoneWhatIsNewAndWhatNobodySaw) {
  const MapChanges changes = mapChanges(before(), after(), {}, 0.0);

  EXPECT_EQ(changes.before.on_walls, 12);
  EXPECT_EQ(changes.before.falsely_occupied, 2);
  EXPECT_EQ(changes.before.unknown, 8);
  EXPECT_EQ(changes.after.on_walls, 12);
  EXPECT_EQ(changes.after.falsely_occupied, 1);
  EXPECT_EQ(changes.after.unknown, 3);
}

TEST(MapChanges, PlacesTheNewerMapAtItsPose) {
  grid::GridGeometry geometry = after().geometry();
  geometry.T_map_grid = grid::Rigid2{3.0, 1.0, 0.5}.inverse() * geometry.T_map_grid;
  const grid::OccupancyGrid moved(geometry, after().values());

  const MapChanges changes = mapChanges(before(), moved, {3.0, 1.0, 0.5}, 0.01);

  EXPECT_EQ(changes.before.falsely_occupied, 2);
  EXPECT_EQ(changes.after.falsely_occupied, 1);
}

TEST(ChangesImage, ShowsWhatIsGoneInRedAndWhatIsNewInGreen) {
  const test::TemporaryDir dir;
  const std::string path = dir / "changes.png";

  writeChangesImage(path, before(), after(), {}, 0.0);

  const cv::Mat image = cv::imread(path, cv::IMREAD_COLOR);
  ASSERT_FALSE(image.empty());
  std::map<std::tuple<int, int, int>, int> pixels;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const cv::Vec3b colour = image.at<cv::Vec3b>(row, column);
      ++pixels[{colour[2], colour[1], colour[0]}];  // red, green, blue
    }
  }
  const int cell = pixels[std::make_tuple(0, 160, 0)];  // one cell is new
  EXPECT_GT(cell, 0);
  EXPECT_EQ(pixels[std::make_tuple(230, 0, 0)], 2 * cell);
  EXPECT_EQ(pixels[std::make_tuple(60, 60, 60)], 12 * cell);
  EXPECT_EQ(pixels[std::make_tuple(150, 150, 150)], 11 * cell);
}

TEST(ChangesImage, ThatCannotBeWrittenIsNamed) {
  EXPECT_THROW(writeChangesImage("/nowhere/changes.png", before(), after(), {}, 0.0), std::runtime_error);
}

}  // namespace
}  // namespace map_matcher::evaluation
