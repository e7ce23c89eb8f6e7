#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "map_matcher/search/counting/rotations.hpp"

namespace map_matcher::search {
namespace {

TEST(Rotations, StepMovesTheFarthestCellByHalfTheDownsamplingAtMost) {
  const double diagonal = 212.0;  // the farthest cell is half of it away from the centre
  for (const double downsampling : {1.0, 2.0, 3.5}) {
    const double step = rotationStep(downsampling, diagonal);

    EXPECT_LE(step * diagonal, downsampling);                        // eq. 4.2
    EXPECT_GT(step * diagonal, 0.99 * downsampling);                 // hardly smaller
    EXPECT_NEAR(std::remainder(2.0 * M_PI / step, 1.0), 0.0, 1e-9);  // whole turn
  }
}

TEST(Rotations, CoverTheFullTurnOnce) {
  const std::vector<double> angles = allRotations(2.0, 100.0);

  EXPECT_EQ(angles.size(), 315U);  // ceil(2 pi / 0.02)
  EXPECT_DOUBLE_EQ(angles.front(), 0.0);
  EXPECT_NEAR(angles.back() + angles[1], 2.0 * M_PI, 1e-9);
}

TEST(Rotations, OfATinySessionAreAtLeastOne) { EXPECT_EQ(allRotations(100.0, 1.0).size(), 1U); }

TEST(Rotations, AroundAnAngleCoverTheWholeInterval) {
  const std::vector<double> angles = rotationsAround(1.0, 0.05, 0.02);

  EXPECT_EQ(angles.front(), 1.0);
  EXPECT_LE(*std::min_element(angles.begin(), angles.end()), 0.95);
  EXPECT_GE(*std::max_element(angles.begin(), angles.end()), 1.05);
}

TEST(Rotations, AroundAnAngleAreNotMoreThanAFullTurn) {
  const std::vector<double> angles = rotationsAround(0.0, 100.0, 0.5);

  EXPECT_LE(angles.size(), 15U);
}

TEST(Rotations, OfPointsRoundDownOnBothSidesOfZero) {
  SessionCells session;
  session.points = {{1.5, 0.25}, {-0.1, -0.9}, {-30000.5, 30000.5}};

  const RotatedCells as_is = rotate(session, 0.0);
  const RotatedCells quarter = rotate(session, M_PI_2);

  EXPECT_EQ(as_is.x, (std::vector<std::int16_t>{1, -1, -30001}));
  EXPECT_EQ(as_is.y, (std::vector<std::int16_t>{0, -1, 30000}));
  EXPECT_EQ(quarter.x, (std::vector<std::int16_t>{-1, 0, -30001}));
  EXPECT_EQ(quarter.y, (std::vector<std::int16_t>{1, -1, -30001}));
}

}  // namespace
}  // namespace map_matcher::search
