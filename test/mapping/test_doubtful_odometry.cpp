#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "map_matcher/mapping/session_mapper.hpp"
#include "support/room.hpp"
#include "support/walls.hpp"

namespace map_matcher::mapping {
namespace {

using test::distanceToWall;
using test::noisy;
using test::Room;
using test::scanFrom;
using test::wallsOf;

/// Drives along a curve through the room with perfect odometry.
void drive(SessionMapper& mapper, const Room& room) {
  for (int i = 0; i <= 40; ++i) {
    const grid::Rigid2 pose{-1.0 + 0.05 * i, 0.3 * std::sin(0.15 * i), 0.03 * i};
    mapper.addScan(0.1 * i, pose, scanFrom(room, pose), {});
  }
}

TEST(DoubtfulOdometry, StaysWhereItIsWhenOdometryJumps) {
  const Room room;
  SessionMapper mapper;
  drive(mapper, room);
  const grid::Rigid2 truth{1.0, 0.3 * std::sin(6.0), 1.2};

  const ScanReport report = mapper.addScan(4.1, {}, scanFrom(room, truth), {});  // back to zero

  EXPECT_NE(report.alarm.find("the odometry jumped"), std::string::npos) << report.alarm;
  const grid::Rigid2 error = truth.inverse() * mapper.T_session_base();
  EXPECT_LT(error.translation().norm(), 0.03);
  EXPECT_LT(std::abs(error.yaw), 0.01);
  mapper.addScan(4.8, {0.3, 0.0, 0.0}, scanFrom(room, truth * grid::Rigid2{0.3, 0.0, 0.0}), {});
  EXPECT_LT((truth.inverse() * mapper.T_session_base()).translation().x(), 0.33);
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    EXPECT_LE(distanceToWall(room, wall), 0.1) << wall.transpose();
  }
}

TEST(DoubtfulOdometry, LeavesTheOdometryAloneAlongACorridorWithoutEnd) {
  const Room corridor{-1000.0, 1000.0, -1.2, 1.3};
  std::mt19937 generator(3);
  SessionMapper mapper;
  grid::Rigid2 truth;
  grid::Rigid2 odometry;
  for (int i = 0; i <= 300; ++i) {  // 15 m
    mapper.addScan(i / 15.0, odometry, noisy(scanFrom(corridor, truth), 0.03, generator), {});
    truth = truth * grid::Rigid2{0.05, 0.0, 0.0};
    odometry = odometry * grid::Rigid2{0.053, 0.0, 0.002};  // 6 % too far, and turning
  }
  truth = truth * grid::Rigid2{-0.05, 0.0, 0.0};

  const grid::Rigid2 error = truth.inverse() * mapper.T_session_base();
  EXPECT_NEAR(error.x, 300 * 0.003, 0.1) << "odometry's error along the corridor, and no more";
  EXPECT_LT(std::abs(error.y), 0.05);
  EXPECT_LT(std::abs(error.yaw), 0.01) << "odometry's is 0.6 rad";
}

}  // namespace
}  // namespace map_matcher::mapping
