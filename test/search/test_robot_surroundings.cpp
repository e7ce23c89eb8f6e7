#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/search/robot_surroundings.hpp"
#include "support/ascii_map.hpp"
#include "support/random_maps.hpp"

namespace map_matcher {
namespace {

constexpr double kResolution = 0.05;

MatchOptions drawnOptions() {
  MatchOptions options;
  options.hit_tolerance = 0.0;
  options.nearby_distance = 2.5;
  return options;
}

Surroundings drawnSurroundings(const std::vector<std::string>& reference_rows,
                               const std::vector<std::string>& session_rows, const Rigid2& T_reference_session,
                               const Eigen::Vector2d& robot, const MatchOptions& options = drawnOptions()) {
  const SearchReference reference(test::asciiMap(reference_rows), 1.0, options);
  const SearchSession session = searchSession(test::asciiMap(session_rows), 1.0, options);
  return surroundings(reference, session, options, T_reference_session, robot);
}

TEST(Surroundings, CountsTheCellsNearTheRobotThatLieOnWalls) {
  const Surroundings nearby = drawnSurroundings({"#.......#",  //
                                                 "#.......#",  //
                                                 "#########"},
                                                {"#.#.....#",  //
                                                 "........#",  //
                                                 "##......#"},
                                                {}, {0.5, 1.5});

  EXPECT_EQ(nearby.cells, 4);
  EXPECT_EQ(nearby.hits, 3);
  EXPECT_DOUBLE_EQ(nearby.ratio(), 0.75);
}

TEST(Surroundings, CountCellsBesideTheReferenceMapAndWhereItIsUnknownAsOffWalls) {
  const Surroundings nearby = drawnSurroundings({"##?",  //
                                                 "..?"},
                                                {"####",  // the last one lies beside the reference map, 2.5 m off
                                                 "#.#."},
                                                {}, {1.0, 1.5});

  EXPECT_EQ(nearby.cells, 6);
  EXPECT_EQ(nearby.hits, 2);
}

TEST(Surroundings, AreThoseOfTheMapWhereItLies) {
  const std::vector<std::string> reference{"....#",  //
                                           "....#",  //
                                           "....."};
  const std::vector<std::string> session{"##"};  // turned left: a column
  const Rigid2 T_reference_session{5.0, 1.0, M_PI / 2.0};

  EXPECT_EQ(drawnSurroundings(reference, session, T_reference_session, {1.0, 0.5}).hits, 2);
  EXPECT_EQ(drawnSurroundings(reference, session, {4.0, 1.0, M_PI / 2.0}, {1.0, 0.5}).hits, 0);
}

TEST(Surroundings, TakeCellsNearWallsForHits) {
  MatchOptions tolerant = drawnOptions();
  tolerant.hit_tolerance = 1.0;

  EXPECT_EQ(drawnSurroundings({"#...#"}, {".#.#."}, {}, {2.5, 0.5}).hits, 0);
  EXPECT_EQ(drawnSurroundings({"#...#"}, {".#.#."}, {}, {2.5, 0.5}, tolerant).hits, 2);
}

TEST(Surroundings, HoldNothingFarFromAllCells) {
  const Surroundings nearby = drawnSurroundings({"#"}, {"#"}, {}, {100.0, 0.0});

  EXPECT_EQ(nearby.cells, 0);
  EXPECT_EQ(nearby.ratio(), 0.0);
}

/// Draws pillars up to 3 m from `place` [m, map frame] into a map, and nothing else.
OccupancyGrid withPillars(OccupancyGrid map, const Eigen::Vector2d& place) {
  constexpr int kSpacing = 22;  // [cells]
  constexpr int kWidth = 3;     // [cells]
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if ((map.geometry().cellCentre({x, y}) - place).norm() < 3.0) {
        map.at(x, y) = x % kSpacing < kWidth && y % kSpacing < kWidth ? kOccupied : kFree;
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

  MatchResult match(const MatchPrior& prior, const MatchOptions& options = {}) const {
    MapMatcher matcher(options);
    matcher.setReference(reference);
    return matcher.match(session, prior);
  }

  std::mt19937 random{4};
  Rigid2 truth{2.0, -1.0, 0.8};
  Eigen::Vector2d robot = truth.inverse() * Eigen::Vector2d(6.5, 4.0);
  Eigen::Vector2d elsewhere = truth.inverse() * Eigen::Vector2d(11.5, 8.5);
  OccupancyGrid reference;
  OccupancyGrid session;
};

MatchPrior robotAt(const Eigen::Vector2d& robot, bool astray = false) {
  MatchPrior prior;
  prior.robot = robot;
  prior.robot_astray = astray;
  return prior;
}

TEST(RobotCheck, TakesBackAMatchThatDoesNotFitAroundTheRobot) {
  const LostRobot scene;

  const MatchResult result = scene.match(robotAt(scene.robot));

  EXPECT_EQ(result.status, MatchStatus::kRobotAstray);
  EXPECT_GT(result.nearby.cells, kFewestNearbyCells);
  EXPECT_LT(result.nearby.ratio(), 0.5);
  EXPECT_TRUE(result.certified);
  EXPECT_EQ(result.covariance.norm(), 0.0);
  EXPECT_NE(result.reason.find("not where the robot is: up to 3 m from it"), std::string::npos) << result.reason;
}

TEST(RobotCheck, LeavesAMatchThatFitsAroundTheRobot) {
  const LostRobot scene;

  for (const bool astray : {false, true}) {
    const MatchResult result = scene.match(robotAt(scene.elsewhere, astray));

    EXPECT_TRUE(result.matched()) << result.reason;
    EXPECT_GT(result.nearby.cells, kFewestNearbyCells);
    EXPECT_GT(result.nearby.ratio(), 0.9);
  }
}

TEST(RobotCheck, AsksForMoreOnceTheRobotWasLost) {
  const LostRobot scene;
  MatchOptions options;
  options.nearby_distance = 100.0;  // the whole map, some of which fits
  const double ratio = scene.match(robotAt(scene.robot), options).nearby.ratio();
  options.min_nearby_ratio = ratio - 0.01;

  ASSERT_LT(ratio, 0.95);
  EXPECT_TRUE(scene.match(robotAt(scene.robot), options).matched());
  EXPECT_EQ(scene.match(robotAt(scene.robot, true), options).status, MatchStatus::kRobotAstray);
}

TEST(RobotCheck, DoesNotLookWithoutARobotOrALimit) {
  const LostRobot scene;
  MatchOptions trusting;
  trusting.min_nearby_ratio = 0.0;

  for (const MatchResult& result : {scene.match({}), scene.match(robotAt(scene.robot), trusting)}) {
    EXPECT_TRUE(result.matched()) << result.reason;
    EXPECT_EQ(result.nearby.cells, 0);
  }
}

TEST(RobotCheck, KeepsToWhatItSaidWhereThereIsTooLittleToLookAt) {
  const LostRobot scene;
  const Eigen::Vector2d beyond_the_map(500.0, 500.0);

  EXPECT_TRUE(scene.match(robotAt(beyond_the_map)).matched());
  EXPECT_EQ(scene.match(robotAt(beyond_the_map, true)).status, MatchStatus::kRobotAstray);
}

}  // namespace
}  // namespace map_matcher
