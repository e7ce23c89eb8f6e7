#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "map_matcher/belief/surroundings.hpp"
#include "support/ascii_map.hpp"
#include "support/matcher.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kResolution = 0.05;

MatchOptions drawnOptions() {
  MatchOptions options;
  options.search.hit_tolerance = 0.0;
  options.belief.nearby_distance = 2.5;
  return options;
}

Surroundings drawnSurroundings(const std::vector<std::string>& reference_rows,
                               const std::vector<std::string>& session_rows, const grid::Rigid2& T_reference_session,
                               const Eigen::Vector2d& robot, const MatchOptions& options = drawnOptions()) {
  const search::Reference reference(test::asciiMap(reference_rows), options.search);
  return surroundings(reference, test::asciiMap(session_rows), options, T_reference_session, robot);
}

TEST(Surroundings, AreTheSessionCellsNearTheRobotAndTheWallsThere) {
  const Surroundings nearby = drawnSurroundings({"#.......#",  //
                                                 "#.......#",  //
                                                 "#########"},
                                                {"#.#.....#",  //
                                                 "........#",  //
                                                 "##??....#"},
                                                {}, {0.5, 1.5});

  EXPECT_EQ(nearby.cells, 4);
  EXPECT_DOUBLE_EQ(nearby.ratio, 0.75);  // not the one at (2.5, 2.5)
  EXPECT_EQ(nearby.walls, 4);            // those at the unknown cell (2.5, 0.5) and far from the robot do not count
  EXPECT_DOUBLE_EQ(nearby.walls_ratio, 0.75);  // not the one at (0.5, 1.5)
}

TEST(Surroundings, CountCellsBesideTheReferenceMapAndWhereItIsUnknownAsOffWalls) {
  const Surroundings nearby = drawnSurroundings({"##?",  //
                                                 "..?"},
                                                {"####",  // the last one lies beside the reference map, 2.5 m off
                                                 "#.#."},
                                                {}, {1.0, 1.5});

  EXPECT_EQ(nearby.cells, 6);
  EXPECT_DOUBLE_EQ(nearby.ratio, 2.0 / 6.0);
  EXPECT_EQ(nearby.walls, 2);
  EXPECT_EQ(nearby.walls_ratio, 1.0);
}

TEST(Surroundings, AreThoseOfTheMapWhereItLies) {
  const std::vector<std::string> reference{"....#",  //
                                           "....#",  //
                                           "....."};
  const std::vector<std::string> session{"##"};  // turned left: a column

  const Surroundings there = drawnSurroundings(reference, session, {5.0, 1.0, M_PI / 2.0}, {1.0, 0.5});
  const Surroundings beside = drawnSurroundings(reference, session, {4.0, 1.0, M_PI / 2.0}, {1.0, 0.5});

  EXPECT_EQ(there.ratio, 1.0);
  EXPECT_EQ(there.walls, 2);
  EXPECT_EQ(there.walls_ratio, 1.0);
  EXPECT_EQ(beside.ratio, 0.0);
  EXPECT_EQ(beside.walls, 0);
}

TEST(Surroundings, TakeCellsNearWallsForHits) {
  MatchOptions tolerant = drawnOptions();
  tolerant.search.hit_tolerance = 1.0;

  EXPECT_EQ(drawnSurroundings({"#...#"}, {".#.#."}, {}, {2.5, 0.5}).ratio, 0.0);
  EXPECT_EQ(drawnSurroundings({"#...#"}, {".#.#."}, {}, {2.5, 0.5}, tolerant).ratio, 1.0);
}

TEST(Surroundings, TakeWallsThatAreBentALittleForTheSame) {
  const auto walls_ratio = [](double drift) {
    const MatchOptions options;
    grid::GridGeometry geometry;
    geometry.width = 100;
    geometry.height = 100;
    geometry.resolution = kResolution;
    grid::OccupancyGrid reference(geometry);
    grid::OccupancyGrid session = reference;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        session.at(x, y) = grid::kFree;
      }
      reference.at(50, y) = grid::kOccupied;
      session.at(50 + static_cast<int>(std::lround(drift / kResolution)), y) = grid::kOccupied;
    }
    return surroundings(search::Reference(reference, options.search), session, options, {}, {2.0, 2.5}).walls_ratio;
  };

  EXPECT_EQ(walls_ratio(0.2), 1.0);
  EXPECT_EQ(walls_ratio(-0.2), 1.0);
  EXPECT_EQ(walls_ratio(0.35), 0.0);
}

TEST(Surroundings, HoldNothingFarFromAllCells) {
  const Surroundings nearby = drawnSurroundings({"#"}, {"#"}, {}, {100.0, 0.0});

  EXPECT_EQ(nearby.cells, 0);
  EXPECT_EQ(nearby.ratio, 0.0);
  EXPECT_EQ(nearby.walls, 0);
  EXPECT_EQ(nearby.walls_ratio, 0.0);
}

constexpr int kEnough = 60;  // cells of 5 cm

Surroundings measured(double ratio, double walls_ratio, int cells = kEnough, int walls = kEnough) {
  return {cells, cells * kResolution, ratio, walls, walls * kResolution, walls_ratio};
}

TEST(IsLost, WhenNeitherCellsNorWallsFit) {
  EXPECT_TRUE(isLost(measured(0.49, 0.89), {}, false));
  EXPECT_FALSE(isLost(measured(0.50, 0.00), {}, false));
  EXPECT_FALSE(isLost(measured(0.00, 0.90), {}, false));
}

TEST(IsLost, UntilBothFit) {
  EXPECT_TRUE(isLost(measured(0.49, 1.00), {}, true));
  EXPECT_TRUE(isLost(measured(1.00, 0.89), {}, true));
  EXPECT_FALSE(isLost(measured(0.50, 0.90), {}, true));
}

TEST(IsLost, AsBeforeWhereThereIsTooLittleToLookAt) {
  for (const bool was_lost : {false, true}) {
    EXPECT_EQ(isLost(measured(0.0, 0.0, kEnough - 1), {}, was_lost), was_lost);
    EXPECT_EQ(isLost(measured(0.0, 0.0, kEnough, kEnough - 1), {}, was_lost), was_lost);
    EXPECT_EQ(isLost(measured(1.0, 1.0, 0, 0), {}, was_lost), was_lost);
  }
}

TEST(IsLost, NeverWithoutALimit) {
  BeliefOptions any_cells;
  any_cells.min_nearby_ratio = 0.0;
  BeliefOptions any_walls;
  any_walls.min_nearby_walls = 0.0;

  EXPECT_FALSE(isLost(measured(0.0, 0.0), any_cells, false));
  EXPECT_FALSE(isLost(measured(0.0, 0.0), any_walls, false));
}

TEST(IsLost, AsksForLengthsOfWallAndNotForCells) {
  const Surroundings fine_cells{150, 150 * 0.02, 0.0,
                                30,  30 * 0.1,   0.0};  // a session map of 2 cm, a reference of 10 cm
  const Surroundings few_fine_cells{149, 149 * 0.02, 0.0, 1000, 1000 * 0.1, 0.0};

  EXPECT_TRUE(isLost(fine_cells, {}, false));
  EXPECT_FALSE(isLost(few_fine_cells, {}, false));
}

/// Draws pillars up to 3 m from `place` [m, map frame] into a map, and nothing else.
grid::OccupancyGrid withPillars(grid::OccupancyGrid map, const Eigen::Vector2d& place) {
  constexpr int kSpacing = 22;  // [cells]
  constexpr int kWidth = 3;     // [cells]
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if ((map.geometry().cellCentre({x, y}) - place).norm() < 3.0) {
        map.at(x, y) = x % kSpacing < kWidth && y % kSpacing < kWidth ? grid::kOccupied : grid::kFree;
      }
    }
  }
  return map;
}

/// A square of a building as a session map, with pillars around the robot that are not there.
struct LostRobot {
  LostRobot()
      : reference(test::randomBuilding(random, 24.0, 12.0, kResolution)),
        session(withPillars(test::cutSession(reference, {9.0, 6.0}, 11.0, truth, kResolution), robot)) {}

  /// The answer when tf has the robot at a place of the session map, or nowhere.
  Answer match(const std::optional<Eigen::Vector2d>& place, bool was_lost = false) const {
    MatchOptions options;
    options.belief.min_probability = 0.0;  // it is low, with walls seen through around the robot
    const test::Matcher matcher(reference, options);
    Circumstances circumstances;
    circumstances.robot_was_lost = was_lost;
    const grid::Rigid2 found = matcher.match(session).search.T_reference_session;
    if (place) {
      circumstances.nearby = surroundings(matcher.reference(), session, options, found, *place);
    }
    return matcher.match(session, {}, {}, circumstances);
  }

  std::mt19937 random{4};
  grid::Rigid2 truth{2.0, -1.0, 0.8};
  Eigen::Vector2d robot = truth.inverse() * Eigen::Vector2d(6.5, 4.0);
  Eigen::Vector2d elsewhere = truth.inverse() * Eigen::Vector2d(11.5, 8.5);
  grid::OccupancyGrid reference;
  grid::OccupancyGrid session;
};

TEST(RobotCheck, TakesBackAMatchThatDoesNotFitAroundTheRobot) {
  const LostRobot scene;

  const Answer result = scene.match(scene.robot);

  EXPECT_EQ(result.status, MatchStatus::kRobotLost);
  EXPECT_GT(result.nearby.cells, kEnough);
  EXPECT_LT(result.nearby.ratio, 0.5);
  EXPECT_GT(result.nearby.walls, kEnough);
  EXPECT_LT(result.nearby.walls_ratio, 0.9);
  EXPECT_TRUE(result.search.certified);
  EXPECT_FALSE(result.alignment());
  EXPECT_NE(result.reason.find("not where the robot is: up to 3 m from it"), std::string::npos) << result.reason;
}

TEST(RobotCheck, LeavesAMatchThatFitsAroundTheRobot) {
  const LostRobot scene;

  for (const bool lost : {false, true}) {
    const Answer result = scene.match(scene.elsewhere, lost);

    EXPECT_TRUE(result.matched()) << result.reason;
    EXPECT_GT(result.nearby.ratio, 0.9);
    EXPECT_GT(result.nearby.walls_ratio, 0.9);
  }
}

TEST(RobotCheck, DoesNotLookWithoutARobot) {
  const Answer result = LostRobot().match(std::nullopt);

  EXPECT_TRUE(result.matched()) << result.reason;
  EXPECT_EQ(result.nearby.cells, 0);
}

TEST(RobotCheck, KeepsToWhatItSaidWhereThereIsTooLittleToLookAt) {
  const LostRobot scene;
  const Eigen::Vector2d beyond_the_map(500.0, 500.0);

  EXPECT_TRUE(scene.match(beyond_the_map).matched());
  EXPECT_EQ(scene.match(beyond_the_map, true).status, MatchStatus::kRobotLost);
}

}  // namespace
}  // namespace map_matcher::belief
