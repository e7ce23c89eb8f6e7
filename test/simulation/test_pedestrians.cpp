#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "map_matcher/simulation/office_building.hpp"
#include "map_matcher/simulation/pedestrians.hpp"
#include "support/ascii_map.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kPeriod = 1.0 / 15.0;

const grid::OccupancyGrid& building() {
  static const grid::OccupancyGrid map = officeBuilding({});
  return map;
}

const World& world() {
  static const World the_world(building());
  return the_world;
}

PedestrianOptions withPeople(int people) {
  PedestrianOptions options;
  options.people = people;
  return options;
}

const RobotSweep kFarAway{{{-100.0, 0.0}}, 0.25, 0.0, {0.0, 0.0}};

Pedestrians crowdOf(const PedestrianOptions& options, std::uint64_t seed = 1) {
  return Pedestrians(world(), options, RandomNumbers(seed), std::nullopt);
}

double smallestBodyDistance(const Pedestrians& crowd) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < crowd.people().size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      smallest = std::min(smallest, (crowd.bodyOf(i).position - crowd.bodyOf(j).position).norm());
    }
  }
  return smallest;
}

class Crowds : public testing::TestWithParam<double> {};

TEST_P(Crowds, touchNeitherWallsNorEachOther) {
  PedestrianOptions options;
  options.density = GetParam();
  Pedestrians crowd = crowdOf(options);
  std::size_t num_legs_in_walls = 0;
  for (int i = 0; i < 450; ++i) {
    crowd.step(kPeriod, kFarAway);
    for (std::size_t k = 0; k < crowd.people().size(); ++k) {
      ASSERT_TRUE(world().isClear(crowd.bodyOf(k).position, options.body_radius)) << k << " at step " << i;
      for (const Circle& leg : crowd.people()[k].legs) {
        num_legs_in_walls += world().isClear(leg.centre, leg.radius) ? 0U : 1U;
      }
    }
    if (i % 30 == 0) {
      ASSERT_GE(smallestBodyDistance(crowd), 2.0 * options.body_radius - 1e-9) << "at step " << i;
    }
  }
  EXPECT_EQ(num_legs_in_walls, 0U);
}

INSTANTIATE_TEST_SUITE_P(Densities, Crowds, testing::Values(0.1, 1.0, 3.0));

TEST(Pedestrians, areAsManyAsAskedFor) {
  EXPECT_EQ(crowdOf(withPeople(37)).people().size(), 37U);
  EXPECT_TRUE(crowdOf({}).people().empty());
}

/// Some free cells are within furniture and in corners that no body gets into.
TEST(Pedestrians, areAsDenseAsAskedFor) {
  const grid::OccupancyGrid& map = building();
  const auto num_free = std::count(map.values().begin(), map.values().end(), grid::kFree);
  const double free_area = static_cast<double>(num_free) * map.resolution() * map.resolution();
  for (const double density : {0.3, 1.0, 3.0}) {
    PedestrianOptions options;
    options.density = density;
    const auto count = static_cast<double>(crowdOf(options).people().size());
    EXPECT_NEAR(count / free_area, 0.9 * density, 0.1 * density) << count << " people on " << free_area << " m^2";
  }
}

TEST(Pedestrians, areAsManyAsFitWhenTheRoomIsFull) {
  const World closet(test::asciiMap({"####", "#..#", "#..#", "####"}, 0.5));
  const Pedestrians crowd(closet, withPeople(50), RandomNumbers(1), std::nullopt);
  EXPECT_GE(crowd.people().size(), 2U);
  EXPECT_LE(crowd.people().size(), 6U);
  const World full(test::asciiMap({"####", "####"}));
  EXPECT_TRUE(Pedestrians(full, withPeople(5), RandomNumbers(1), std::nullopt).people().empty());
}

TEST(Pedestrians, walkOrStandAsAskedFor) {
  PedestrianOptions options = withPeople(100);
  options.standing_share = 0.4;
  Pedestrians crowd = crowdOf(options);
  std::vector<Eigen::Vector2d> start;
  for (std::size_t i = 0; i < 100; ++i) {
    start.push_back(crowd.bodyOf(i).position);
  }
  double farthest = 0.0;
  for (int i = 0; i < 300; ++i) {
    crowd.step(kPeriod, kFarAway);
  }
  int num_standing = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const double distance = (crowd.bodyOf(i).position - start[i]).norm();
    num_standing += distance == 0.0 ? 1 : 0;
    farthest = std::max(farthest, distance);
  }
  EXPECT_EQ(num_standing, 40);
  EXPECT_GT(farthest, 10.0);
}

/// Distances walked in 30 s against the speeds of people with nobody in their way.
TEST(Pedestrians, walkAtAboutTheirSpeedWhereThereIsRoom) {
  PedestrianOptions options = withPeople(40);
  options.standing_share = 0.0;
  Pedestrians crowd = crowdOf(options);
  double walked = 0.0;
  for (int i = 0; i < 450; ++i) {
    std::vector<Eigen::Vector2d> before;
    for (std::size_t k = 0; k < 40; ++k) {
      before.push_back(crowd.bodyOf(k).position);
    }
    crowd.step(kPeriod, kFarAway);
    for (std::size_t k = 0; k < 40; ++k) {
      walked += (crowd.bodyOf(k).position - before[k]).norm();
    }
  }
  const double mean_speed = walked / 40.0 / 30.0;
  EXPECT_GT(mean_speed, 0.7);
  EXPECT_LT(mean_speed, 1.1);
}

TEST(Pedestrians, haveTheirPositionBetweenTheirLegs) {
  Pedestrians crowd = crowdOf(withPeople(30));
  for (int i = 0; i < 100; ++i) {
    crowd.step(kPeriod, kFarAway);
    for (std::size_t k = 0; k < 30; ++k) {
      const Person& person = crowd.people()[k];
      EXPECT_TRUE(person.position.isApprox(0.5 * (person.legs[0].centre + person.legs[1].centre)));
      EXPECT_LT((person.position - crowd.bodyOf(k).position).norm(), 0.35);
      EXPECT_GT(person.legs[0].radius, 0.05);
      EXPECT_LT(person.legs[0].radius, 0.08);
    }
  }
}

TEST(Pedestrians, keepOffARobotThatStands) {
  const RobotSweep robot{{{27.0, 7.0}}, 0.25, 0.0, {0.0, 0.0}};
  PedestrianOptions options;
  options.density = 1.5;
  Pedestrians crowd(world(), options, RandomNumbers(2), Circle{robot.centres.front(), 0.4});
  for (int i = 0; i < 450; ++i) {
    crowd.step(kPeriod, robot);
    for (std::size_t k = 0; k < crowd.people().size(); ++k) {
      const double allowed = robot.radius + Pedestrians::kDistanceToRobot - 1e-9;
      ASSERT_GE((crowd.bodyOf(k).position - robot.centres.front()).norm(), allowed + options.body_radius);
      for (const Circle& leg : crowd.people()[k].legs) {
        ASSERT_GE((leg.centre - robot.centres.front()).norm(), allowed + leg.radius);
      }
    }
  }
}

TEST(Pedestrians, areTheSameForTheSameSeedOnly) {
  PedestrianOptions options;
  options.density = 0.3;
  Pedestrians one = crowdOf(options, 4);
  Pedestrians same = crowdOf(options, 4);
  Pedestrians other = crowdOf(options, 5);
  for (int i = 0; i < 100; ++i) {
    one.step(kPeriod, kFarAway);
    same.step(kPeriod, kFarAway);
  }
  ASSERT_EQ(one.people().size(), same.people().size());
  for (std::size_t k = 0; k < one.people().size(); ++k) {
    EXPECT_EQ(one.people()[k].position, same.people()[k].position);
  }
  EXPECT_NE(one.people()[0].position, other.people()[0].position);
}

TEST(Pedestrians, nameEveryOptionOutOfItsRange) {
  PedestrianOptions options;
  options.density = 4.0;
  options.standing_share = 1.5;
  options.leg_radius = 0.2;
  const std::string text = test::thrownText<std::invalid_argument>([&] { crowdOf(options); });
  for (const char* problem : {"density is 4, expected 0 to 3 1/m^2", "standing_share is 1.5", "leg_radius is 0.2"}) {
    EXPECT_NE(text.find(problem), std::string::npos) << problem << " is not in: " << text;
  }
}

}  // namespace
}  // namespace map_matcher::simulation
