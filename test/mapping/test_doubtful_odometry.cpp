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

TEST(DoubtfulOdometry, LeavesAScanThatSeesThroughWallsOutOfTheMap) {
  SessionMapper mapper;
  mapper.addScan(0.0, {}, scanFrom({}, {}), {});
  const auto before = mapper.map()->values();
  const grid::Rigid2 moved{0.4, 0.0, 0.0};

  const ScanReport report = mapper.addScan(1.0, moved, scanFrom({-9.0, 9.0, -6.0, 6.5}, {}), {});

  EXPECT_EQ(report.outcome, ScanOutcome::kNotFitting);
  EXPECT_NE(report.reason.find("go through walls"), std::string::npos) << report.reason;
  EXPECT_EQ(mapper.map()->values(), before);
  EXPECT_NEAR(mapper.T_session_base().x, 0.4, 1e-12);
}

TEST(DoubtfulOdometry, EndsASessionThatScanAfterScanContradicts) {
  const Room elsewhere{-9.0, 9.0, -6.0, 6.5};
  SessionMapper mapper;
  mapper.addScan(0.0, {}, scanFrom({}, {}), {});

  int scans = 0;
  ScanReport report;
  for (; scans < 30 && !report.new_session; ++scans) {
    report = mapper.addScan(1.0 + scans, {0.01 * scans, 0.0, 0.0}, scanFrom(elsewhere, {0.01 * scans, 0.0, 0.0}), {});
  }

  ASSERT_TRUE(report.new_session);
  EXPECT_GE(scans, 5) << "one scan or two tell nothing";
  EXPECT_NE(report.alarm.find("a new one begins"), std::string::npos) << report.alarm;
  EXPECT_EQ(report.outcome, ScanOutcome::kDrawn);
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    EXPECT_LE(distanceToWall(elsewhere, wall), 0.05) << wall.transpose();
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

TEST(DoubtfulOdometry, FollowsTheWallsWhenOdometryStandsStill) {
  const Room room;
  SessionMapper mapper;
  drive(mapper, room);
  const grid::Rigid2 odometry{1.0, 0.3 * std::sin(6.0), 1.2};
  grid::Rigid2 truth = odometry;
  bool told = false;
  for (int i = 1; i <= 60; ++i) {  // backs off for 4 s at 0.3 m/s
    truth = truth * grid::Rigid2{-0.02, 0.0, 0.0};
    const ScanReport report = mapper.addScan(4.0 + i / 15.0, odometry, scanFrom(room, truth), {});
    told = told || !report.alarm.empty();
  }

  EXPECT_TRUE(told);
  EXPECT_LT((truth.inverse() * mapper.T_session_base()).translation().norm(), 0.1);
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    EXPECT_LE(distanceToWall(room, wall), 0.12) << wall.transpose();
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
