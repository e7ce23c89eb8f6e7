#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "map_matcher/simulation/robot.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using test::thrownText;

RobotOptions nimble() {
  RobotOptions options;
  options.max_acceleration = 10.0;
  options.max_turn_acceleration = 100.0;
  return options;
}

TEST(DifferentialDrive, drivesAlongArcs) {
  DifferentialDrive robot(nimble(), {1.0, 2.0, M_PI / 2.0});
  robot.drive({0.5, 0.5}, M_PI);  // a quarter of a circle of 1 m radius, to the left
  EXPECT_NEAR(robot.T_map_base().x, 0.0, 1e-12);
  EXPECT_NEAR(robot.T_map_base().y, 3.0, 1e-12);
  EXPECT_NEAR(robot.T_map_base().yaw, M_PI, 1e-12);
}

TEST(DifferentialDrive, drivesStraightAndTurnsInPlace) {
  DifferentialDrive robot(nimble(), {0.0, 0.0, 0.0});
  robot.drive({0.5, 0.0}, 2.0);
  robot.drive({0.0, -1.0}, 1.0);
  EXPECT_NEAR(robot.T_map_base().x, 1.0, 1e-12);
  EXPECT_NEAR(robot.T_map_base().y, 0.0, 1e-12);
  EXPECT_NEAR(robot.T_map_base().yaw, -1.0, 1e-12);
}

TEST(DifferentialDrive, changesItsVelocityNoFasterThanItCan) {
  RobotOptions options;
  options.max_acceleration = 0.5;
  options.max_turn_acceleration = 2.0;
  DifferentialDrive robot(options, {});
  robot.drive({1.0, 1.0}, 0.1);
  EXPECT_DOUBLE_EQ(robot.velocity().linear, 0.05);
  EXPECT_DOUBLE_EQ(robot.velocity().angular, 0.2);
  robot.drive({0.0, -1.0}, 0.05);
  EXPECT_DOUBLE_EQ(robot.velocity().linear, 0.025);
  EXPECT_DOUBLE_EQ(robot.velocity().angular, 0.1);
}

TEST(DifferentialDrive, drivesAndTurnsNoFasterThanItCan) {
  DifferentialDrive robot(nimble(), {});
  robot.drive({5.0, -50.0}, 1.0);
  EXPECT_DOUBLE_EQ(robot.velocity().linear, robot.options().max_speed);
  EXPECT_DOUBLE_EQ(robot.velocity().angular, -robot.options().max_turn_rate);
}

TEST(DifferentialDrive, namesEveryOptionOutOfItsRange) {
  RobotOptions options;
  options.radius = 0.0;
  options.max_speed = -1.0;
  const std::string text = thrownText<std::invalid_argument>([&] { DifferentialDrive(options, {}); });
  EXPECT_NE(text.find("radius is 0, expected 0.01 to 2 m"), std::string::npos) << text;
  EXPECT_NE(text.find("max_speed is -1, expected 0.05 to 5 m/s"), std::string::npos) << text;
}

OdometryOptions noNoise() { return {0.0, 0.0, 0.0, 0.0}; }

/// Reads n steps of this motion, in the robot's frame.
grid::Rigid2 odometryAfter(const OdometryOptions& options, const grid::Rigid2& step, int n, std::uint64_t seed) {
  grid::Rigid2 T_map_base{3.0, -1.0, 2.0};
  Odometry odometry(options, T_map_base, RandomNumbers(seed));
  for (int i = 0; i < n; ++i) {
    T_map_base = T_map_base * step;
    odometry.read(T_map_base);
  }
  return odometry.T_odom_base();
}

TEST(Odometry, withoutNoiseIsTheTruthFromTheFirstPoseOn) {
  const grid::Rigid2 start{3.0, -1.0, 2.0};
  grid::Rigid2 T_map_base = start;
  Odometry odometry(noNoise(), start, RandomNumbers(1));
  for (const grid::Rigid2& step :
       {grid::Rigid2{0.1, 0.01, 0.2}, grid::Rigid2{0.0, 0.0, -1.5}, grid::Rigid2{}, grid::Rigid2{0.3, -0.1, 3.0}}) {
    T_map_base = T_map_base * step;
    odometry.read(T_map_base);
    const grid::Rigid2 expected = start.inverse() * T_map_base;
    EXPECT_NEAR(odometry.T_odom_base().x, expected.x, 1e-12);
    EXPECT_NEAR(odometry.T_odom_base().y, expected.y, 1e-12);
    EXPECT_NEAR(grid::normalizeAngle(odometry.T_odom_base().yaw - expected.yaw), 0.0, 1e-12);
  }
}

TEST(Odometry, standsStillWithTheRobot) {
  const grid::Rigid2 pose = odometryAfter({}, {}, 1000, 1);
  EXPECT_EQ(pose.x, 0.0);
  EXPECT_EQ(pose.y, 0.0);
  EXPECT_EQ(pose.yaw, 0.0);
}

/// Root mean square of what an error function says about many readings.
template <typename ErrorOf>
double spread(const OdometryOptions& options, const grid::Rigid2& step, const ErrorOf& error_of) {
  constexpr int kReadings = 20000;
  double square = 0.0;
  for (int seed = 0; seed < kReadings; ++seed) {
    const double error = error_of(odometryAfter(options, step, 1, static_cast<std::uint64_t>(seed)));
    square += error * error / kReadings;
  }
  return std::sqrt(square);
}

TEST(Odometry, noiseFollowsTheMotionModel) {
  const grid::Rigid2 straight{0.5, 0.0, 0.0};
  const grid::Rigid2 turn{0.0, 0.0, 0.8};
  const auto yaw_error = [](const grid::Rigid2& read) { return read.yaw; };
  const auto turn_error = [](const grid::Rigid2& read) { return read.yaw - 0.8; };
  const auto distance_error = [](const grid::Rigid2& read) { return read.translation().norm() - 0.5; };
  const auto distance = [](const grid::Rigid2& read) { return read.translation().norm(); };

  EXPECT_NEAR(spread({0.01, 0.0, 0.0, 0.0}, turn, turn_error), std::sqrt(0.01) * 0.8, 0.002);
  EXPECT_NEAR(spread({0.0, 0.01, 0.0, 0.0}, straight, yaw_error), std::sqrt(2.0 * 0.01) * 0.5, 0.002);  // two turns
  EXPECT_NEAR(spread({0.0, 0.0, 0.01, 0.0}, straight, distance_error), std::sqrt(0.01) * 0.5, 0.002);
  EXPECT_NEAR(spread({0.0, 0.0, 0.0, 0.01}, turn, distance), std::sqrt(0.01) * 0.8, 0.002);
}

TEST(Odometry, namesEveryOptionOutOfItsRange) {
  const std::string text = thrownText<std::invalid_argument>([] {
    Odometry({-1.0, 0.0, 2.0, 0.0}, {}, RandomNumbers(1));
  });
  EXPECT_NE(text.find("alpha1 is -1, expected 0 to 1"), std::string::npos) << text;
  EXPECT_NE(text.find("alpha3 is 2, expected 0 to 1"), std::string::npos) << text;
}

}  // namespace
}  // namespace map_matcher::simulation
