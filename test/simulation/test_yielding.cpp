#include <gtest/gtest.h>

#include "map_matcher/simulation/yielding.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kPeriod = 0.02;

/// At 0.6 m/s along x through the origin, once it has come to speed.
DifferentialDrive movingRobot() {
  RobotOptions options;
  options.max_acceleration = 0.5;
  DifferentialDrive robot(options, {-2.0, 0.0, 0.0});
  for (int i = 0; i < 100; ++i) {
    robot.drive({0.6, 0.0}, kPeriod);
  }
  return robot;
}

/// From 0.6 m/s at 0.5 m/s^2 it takes 0.36 m, a little less as a step's speed is that at its end.
TEST(Yielding, knowsWhereTheRobotStops) {
  const DifferentialDrive robot = movingRobot();
  const std::vector<Eigen::Vector2d> way = brakingWay(robot, kPeriod);
  EXPECT_EQ(way.front(), robot.T_map_base().translation());
  EXPECT_NEAR((way.back() - way.front()).norm(), 0.36, 0.01);
  EXPECT_NEAR(static_cast<double>(way.size()), 0.6 / 0.5 / kPeriod + 1.0, 1.0);
}

TEST(Yielding, letsTheRobotDriveWhereNobodyIs) {
  const Velocity velocity = yieldTo({{{3.0, 2.0}, 0.2}}, movingRobot(), {0.5, 0.3}, kPeriod);
  EXPECT_EQ(velocity.linear, 0.5);
  EXPECT_EQ(velocity.angular, 0.3);
}

TEST(Yielding, stopsTheRobotBeforeSomebodyWhoStandsInTheWay) {
  DifferentialDrive robot = movingRobot();
  const Circle person{{robot.T_map_base().x + 2.0, 0.1}, 0.2};
  for (int i = 0; i < 500; ++i) {
    robot.drive(yieldTo({person}, robot, {0.6, 0.0}, kPeriod), kPeriod);
  }
  EXPECT_EQ(robot.velocity().linear, 0.0);
  const double gap = (robot.T_map_base().translation() - person.centre).norm() - 0.2 - robot.options().radius;
  EXPECT_GE(gap, kDistanceToPeople);
  EXPECT_LT(gap, kDistanceToPeople + 0.05);
}

TEST(Yielding, letsTheRobotTurnAndLeaveWhereSomebodyIsNear) {
  DifferentialDrive robot(RobotOptions{}, {0.0, 0.0, 0.0});
  const std::vector<Circle> people{{{-0.5, 0.0}, 0.2}};
  EXPECT_EQ(yieldTo(people, robot, {0.0, 1.0}, kPeriod).angular, 1.0);
  EXPECT_EQ(yieldTo(people, robot, {0.4, 0.0}, kPeriod).linear, 0.4);
  const std::vector<Circle> ahead{{{0.5, 0.0}, 0.2}};
  EXPECT_EQ(yieldTo(ahead, robot, {0.4, 0.0}, kPeriod).linear, 0.0);
}

}  // namespace
}  // namespace map_matcher::simulation
