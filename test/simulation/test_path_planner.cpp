#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "map_matcher/grid/resample.hpp"
#include "map_matcher/simulation/path_planner.hpp"
#include "support/ascii_map.hpp"
#include "support/ray_oracle.hpp"

namespace map_matcher::simulation {
namespace {

using test::asciiMap;

double lengthOf(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (path[i] - path[i - 1]).norm();
  }
  return length;
}

/// Half a metre a drawn cell, in cells of 5 cm.
grid::OccupancyGrid twoRooms(const std::string& wall) {
  return grid::resample(asciiMap({"####################",  //
                                  "#........#.........#",  //
                                  "#........#.........#",  //
                                  "#........#.........#",  //
                                  wall,                    //
                                  wall,                    //
                                  wall,                    //
                                  "#........#.........#",  //
                                  "####################"},
                                 0.5),
                        0.05);
}

TEST(PathPlanner, findsTheDoorAndKeepsItsClearance) {
  const grid::OccupancyGrid grid = twoRooms("#..................#");
  const World world(grid);
  const PathPlanner planner(world, 0.3);
  const Eigen::Vector2d start(1.2, 3.3);
  const Eigen::Vector2d goal(8.7, 3.2);
  const auto path = planner.plan(start, goal);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->front(), start);
  EXPECT_EQ(path->back(), goal);
  double lowest_in_door = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path->size(); ++i) {
    const Eigen::Vector2d& p = (*path)[i];
    EXPECT_GE(test::clearanceByEveryCell(grid, p), 0.3) << p.transpose();
    EXPECT_LE((p - (*path)[i - 1]).norm(), 0.3);
    if (p.x() > 4.5 && p.x() < 5.0) {
      lowest_in_door = std::min(lowest_in_door, p.y());
    }
  }
  EXPECT_GT(lowest_in_door, 1.0);
  EXPECT_LT(lowest_in_door, 2.5);
  EXPECT_LT(lengthOf(*path), 11.0);
}

TEST(PathPlanner, findsNoWayThroughAClosedWallOrANarrowDoor) {
  const World closed(twoRooms("#........#.........#"));
  EXPECT_FALSE(PathPlanner(closed, 0.3).plan({1.2, 3.3}, {8.7, 3.2}));
  const World open(twoRooms("#..................#"));
  EXPECT_TRUE(PathPlanner(open, 0.5).plan({1.5, 3.0}, {8.5, 3.0}));
  EXPECT_FALSE(PathPlanner(open, 0.8).plan({1.5, 3.0}, {8.5, 3.0}));
}

TEST(PathPlanner, hasNoWayToOrFromPlacesWhereTheRobotDoesNotFit) {
  const World world(twoRooms("#..................#"));
  const PathPlanner planner(world, 0.3);
  EXPECT_FALSE(planner.plan({1.2, 3.3}, {0.6, 3.3}));   // too near to the wall
  EXPECT_FALSE(planner.plan({1.2, 3.3}, {4.75, 3.3}));  // in the wall
  EXPECT_FALSE(planner.plan({1.2, 3.3}, {-3.0, 3.3}));  // outside
  EXPECT_FALSE(planner.plan({4.75, 3.3}, {1.2, 3.3}));  // from the wall
  EXPECT_FALSE(planner.plan({1.2, 3.3}, {std::nan(""), 3.3}));
}

TEST(PathPlanner, leavesAPlaceWithLittleClearance) {
  const World world(twoRooms("#..................#"));
  const auto path = PathPlanner(world, 0.3).plan({0.75, 3.3}, {8.7, 3.2});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->front(), Eigen::Vector2d(0.75, 3.3));
}

TEST(PathPlanner, prefersTheMiddleOfAWideSpaceToItsWalls) {
  const World world(
      grid::resample(asciiMap({"##########", "#........#", "#........#", "#........#", "##########"}), 0.05));
  const auto path = PathPlanner(world, 0.3).plan({1.5, 1.5}, {8.5, 1.5});
  ASSERT_TRUE(path);
  const Eigen::Vector2d middle = (*path)[path->size() / 2];
  EXPECT_GT(middle.y(), 1.7);
}

TEST(PathPlanner, namesThePlacesOfTheLargestRoom) {
  const World world(twoRooms("#........#.........#"));
  const PathPlanner planner(world, 0.3);
  ASSERT_FALSE(planner.places().empty());
  for (const Eigen::Vector2d& place : planner.places()) {
    EXPECT_GT(place.x(), 5.0);  // the right room is the wider one
    EXPECT_TRUE(world.isClear(place, 0.3));
  }
}

TEST(PathPlanner, namesNoPlaceWhereThereIsNone) {
  EXPECT_TRUE(PathPlanner(World(asciiMap({"###", "#.#", "###"}, 0.5)), 0.3).places().empty());
  EXPECT_TRUE(PathPlanner(World(asciiMap({"   ", "   ", "   "})), 0.3).places().empty());
}

TEST(PathPlanner, worksInATurnedMap) {
  const grid::Rigid2 T_map_grid{-7.0, 4.0, 2.5};
  const grid::OccupancyGrid upright = twoRooms("#..................#");
  grid::GridGeometry geometry = upright.geometry();
  geometry.T_map_grid = T_map_grid;
  const World world(grid::OccupancyGrid(geometry, upright.values()));
  const auto path = PathPlanner(world, 0.3)
                        .plan(T_map_grid * Eigen::Vector2d(1.2, 3.3),  //
                              T_map_grid * Eigen::Vector2d(8.7, 3.2));
  const auto expected = PathPlanner(World(upright), 0.3).plan({1.2, 3.3}, {8.7, 3.2});
  ASSERT_TRUE(path);
  ASSERT_TRUE(expected);
  EXPECT_NEAR(lengthOf(*path), lengthOf(*expected), 0.3);
}

TEST(PathPlanner, refusesAClearanceThatIsNotPositive) {
  const World world(asciiMap({"..."}));
  EXPECT_THROW(PathPlanner(world, 0.0), std::invalid_argument);
  EXPECT_THROW(PathPlanner(world, std::nan("")), std::invalid_argument);
}

TEST(PathPlanner, findsTheNearestOfSeveralGoals) {
  const World world(twoRooms("#..................#"));
  const PathPlanner planner(world, 0.3);
  const Eigen::Vector2d start(1.2, 3.3);
  const auto far_away = [](const Eigen::Vector2d& p) { return p.x() > 5.5; };
  const auto path = planner.planToNearest(start, far_away);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->front(), start);
  EXPECT_NEAR(path->back().x(), 5.55, 0.06);
  for (std::size_t i = 1; i + 1 < path->size(); ++i) {
    EXPECT_FALSE(far_away((*path)[i]));
  }
  EXPECT_FALSE(planner.planToNearest(start, [](const Eigen::Vector2d& p) { return p.x() > 50.0; }));
  EXPECT_FALSE(planner.planToNearest({-3.0, 3.3}, far_away));
}

TEST(PathPlanner, leadsFromEverywhereToAGoal) {
  const grid::OccupancyGrid grid = twoRooms("#..................#");
  const World world(grid);
  const PathPlanner planner(world, 0.3);
  const Eigen::Vector2d goal(8.7, 3.2);
  const WayField field = planner.waysTo(goal);
  for (const Eigen::Vector2d& place : planner.places()) {
    const std::vector<Eigen::Vector2d> way = field.ahead(place, 100.0);
    ASSERT_FALSE(way.empty());
    EXPECT_LT((way.front() - place).norm(), 1e-9);
    EXPECT_LT((way.back() - goal).norm(), 0.1);
    for (const Eigen::Vector2d& p : way) {
      ASSERT_TRUE(world.isClear(p, 0.3));
    }
  }
  const std::vector<Eigen::Vector2d> start = field.ahead({1.2, 3.3}, 1.0);
  EXPECT_NEAR(lengthOf(start), 1.0, 0.15);
  const auto path = planner.plan({1.2, 3.3}, goal);
  EXPECT_NEAR(lengthOf(field.ahead({1.2, 3.3}, 100.0)), lengthOf(*path), 0.3);
}

TEST(PathPlanner, leadsNowhereFromOrToPlacesThatCannotBeReached) {
  const World world(twoRooms("#........#.........#"));
  const PathPlanner planner(world, 0.3);
  EXPECT_TRUE(planner.waysTo({8.7, 3.2}).ahead({1.2, 3.3}, 1.0).empty());
  EXPECT_TRUE(planner.waysTo({4.75, 3.3}).ahead({1.2, 3.3}, 1.0).empty());
  EXPECT_FALSE(planner.waysTo({8.7, 3.2}).ahead({5.2, 3.3}, 1.0).empty());  // too near to the wall, but not far off
}

/// A room of 9 m x 3.5 m: its corners cannot be covered by a circle.
TEST(PathPlanner, knowsTheAreaThatCanBeCovered) {
  const World world(grid::resample(asciiMap({"####################",  //
                                             "#..................#",  //
                                             "#..................#",  //
                                             "#..................#",  //
                                             "#..................#",  //
                                             "#..................#",  //
                                             "#..................#",  //
                                             "#..................#",  //
                                             "####################"},
                                            0.5),
                                   0.05));
  EXPECT_NEAR(PathPlanner(world, 0.2).coveredArea(), 9.0 * 3.5, 0.9);
}

}  // namespace
}  // namespace map_matcher::simulation
