#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "map_matcher/search/counting/session_cells.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

std::vector<std::pair<double, double>> sorted(const SessionCells& session) {
  std::vector<std::pair<double, double>> points;
  for (const Eigen::Vector2d& p : session.points) {
    points.emplace_back(p.x(), p.y());
  }
  std::sort(points.begin(), points.end());
  return points;
}

TEST(SessionCells, AreCentresAroundTheMiddleOfTheirBox) {
  const SessionCells session = prepareSessionCells({{10, 20}, {13, 20}, {11, 24}}, 0.1, 0.1, CellMerging::kNone, 0);

  EXPECT_TRUE(session.centre.isApprox(Eigen::Vector2d(1.2, 2.25)));
  EXPECT_DOUBLE_EQ(session.diagonal, std::hypot(4.0, 5.0));
  EXPECT_EQ(session.longest_side, 5);
  const std::vector<std::pair<double, double>> expected{{-1.5, -2.0}, {-0.5, 2.0}, {1.5, -2.0}};
  EXPECT_EQ(sorted(session), expected);
}

TEST(SessionCells, ThatFallIntoTheSameLargerCellBecomeOneAtTheirMean) {
  const SessionCells session = prepareSessionCells({{0, 0}, {1, 1}, {3, 0}, {3, 1}}, 0.05, 0.1, CellMerging::kMerge, 0);

  EXPECT_TRUE(session.centre.isApprox(Eigen::Vector2d(0.1, 0.05)));
  const std::vector<std::pair<double, double>> expected{{-0.5, 0.0}, {0.75, 0.0}};
  EXPECT_EQ(sorted(session), expected);
}

TEST(SessionCells, KeepTheirNumberAtAnotherResolutionWhenTheyAreNotMerged) {
  const SessionCells session = prepareSessionCells({{0, 0}, {1, 0}}, 0.05, 0.1, CellMerging::kNone, 0);

  const std::vector<std::pair<double, double>> expected{{-0.25, 0.0}, {0.25, 0.0}};
  EXPECT_EQ(sorted(session), expected);
}

TEST(SessionCells, AreSampledReproduciblyAndFromEverywhere) {
  std::mt19937 random(7);
  const std::vector<grid::Cell> cells = test::randomCells(random, 200, 100, 5000);

  const SessionCells once = prepareSessionCells(cells, 0.05, 0.05, CellMerging::kNone, 400);
  const SessionCells again = prepareSessionCells(cells, 0.05, 0.05, CellMerging::kNone, 400);
  const SessionCells all = prepareSessionCells(cells, 0.05, 0.05, CellMerging::kNone, 0);

  ASSERT_EQ(once.points.size(), 400U);
  EXPECT_EQ(sorted(once), sorted(again));
  EXPECT_EQ(once.diagonal, all.diagonal);  // the number of rotations does not depend on the sample
  const auto to_the_right =
      std::count_if(once.points.begin(), once.points.end(), [](const auto& p) { return p.x() > 0; });
  EXPECT_NEAR(static_cast<double>(to_the_right), 200.0, 50.0);
}

TEST(SessionCells, AreDownsampledUntilACellIsAsLargeAsTheSession) {
  SessionCells session;
  for (const auto& [side, steps] : {std::pair(1, 0), std::pair(2, 1), std::pair(3, 1), std::pair(150, 7)}) {
    session.longest_side = side;
    EXPECT_EQ(downsamplingSteps(session), steps) << side;  // eq. 4.1
  }
}

TEST(SessionCells, ThresholdAboveTheirNumberKeepsAll) {
  EXPECT_EQ(prepareSessionCells({{0, 0}, {4, 2}}, 0.05, 0.05, CellMerging::kNone, 10).points.size(), 2U);
}

}  // namespace
}  // namespace map_matcher::search
