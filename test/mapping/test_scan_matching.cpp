#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/mapping/scan_matching.hpp"
#include "support/room.hpp"

namespace map_matcher::mapping {
namespace {

using test::Room;
using test::scanFrom;

BeamFan fanFrom(const Room& room, const grid::Rigid2& pose) { return castBeams(scanFrom(room, pose), {}, {}); }

/// What was drawn of a room from several places.
HitCountingGrid drawn(const Room& room) {
  HitCountingGrid grid(0.05, {{-5.0, -5.0}, {5.0, 5.0}});
  for (int i = 0; i < 20; ++i) {
    const grid::Rigid2 pose{-0.5 + 0.05 * i, 0.02 * i, 0.3 * i};
    grid.draw(transform(pose, fanFrom(room, pose)));
  }
  return grid;
}

PoseEstimate around(const grid::Rigid2& pose, double position, double heading) {
  return {pose, Eigen::Vector3d(position * position, position * position, heading * heading).asDiagonal()};
}

TEST(ScanMatching, FindsThePoseFinerThanTheCells) {
  const Room room{-3.0, 4.013, -2.0, 2.537};
  const grid::Rigid2 truth{0.3, -0.2, 0.4};

  const ScanMatch match = matchScan(drawn(room), fanFrom(room, truth), around({0.45, -0.3, 0.3}, 0.2, 0.1), {});

  const grid::Rigid2 error = truth.inverse() * match.estimate.T_session_base;
  EXPECT_LT(error.translation().norm(), 0.005);
  EXPECT_LT(std::abs(error.yaw), 0.002);
  EXPECT_GT(match.fit, 0.98);
  EXPECT_LT(match.estimate.covariance.diagonal().maxCoeff(), 0.01 * 0.01);
}

TEST(ScanMatching, StaysWithThePredictionWhereNothingWasDrawn) {
  const grid::Rigid2 prediction{50.0, 60.0, 1.0};

  const ScanMatch match = matchScan(drawn({}), fanFrom({}, {}), around(prediction, 0.1, 0.05), {});

  EXPECT_NEAR(match.estimate.T_session_base.x, 50.0, 1e-9);
  EXPECT_NEAR(match.estimate.T_session_base.yaw, 1.0, 1e-9);
  EXPECT_EQ(match.points, 0);
  EXPECT_NEAR(match.estimate.covariance(0, 0), 0.1 * 0.1, 1e-6);
}

TEST(ScanMatching, IsNotMovedByEndsThatAreFarFromWalls) {
  const Room room;
  const grid::Rigid2 truth{0.3, -0.2, 0.4};
  scan::PlanarScan scan = scanFrom(room, truth);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (i % 5 < 3) {  // three beams of five end at people
      scan.ranges[i] *= 0.7F;
    }
  }

  const ScanMatch match = matchScan(drawn(room), castBeams(scan, {}, {}), around({0.33, -0.22, 0.43}, 0.1, 0.05), {});

  const grid::Rigid2 error = truth.inverse() * match.estimate.T_session_base;
  EXPECT_LT(error.translation().norm(), 0.01);
  EXPECT_LT(std::abs(error.yaw), 0.004);
  EXPECT_LT(match.fit, 0.7);
}

TEST(ScanMatching, BelievesThePredictionAsMuchAsItIsSure) {
  const Room room;
  const grid::Rigid2 truth{0.3, -0.2, 0.4};
  const grid::Rigid2 prediction{0.34, -0.2, 0.4};

  const double of_doubtful =
      matchScan(drawn(room), fanFrom(room, truth), around(prediction, 0.1, 0.05), {}).estimate.T_session_base.x;
  const double of_sure =
      matchScan(drawn(room), fanFrom(room, truth), around(prediction, 0.0005, 0.0005), {}).estimate.T_session_base.x;

  EXPECT_NEAR(of_doubtful, 0.3, 0.003);
  EXPECT_NEAR(of_sure, 0.34, 0.01);
}

TEST(ScanMatching, KnowsThatItKnowsNothingAlongACorridor) {
  const Room corridor{-1000.0, 1000.0, -1.2, 1.3};
  HitCountingGrid grid(0.05, {{-5.0, -5.0}, {5.0, 5.0}});
  grid.draw(fanFrom(corridor, {}));

  const ScanMatch match = matchScan(grid, fanFrom(corridor, {}), around({0.2, 0.05, 0.03}, 0.2, 0.1), {});

  EXPECT_NEAR(match.estimate.T_session_base.x, 0.2, 0.01);
  EXPECT_NEAR(match.estimate.T_session_base.y, 0.0, 0.01);
  EXPECT_NEAR(match.estimate.T_session_base.yaw, 0.0, 0.005);
  EXPECT_NEAR(std::sqrt(match.estimate.covariance(0, 0)), 0.2, 0.02);
  EXPECT_LT(std::sqrt(match.estimate.covariance(1, 1)), 0.02);
}

}  // namespace
}  // namespace map_matcher::mapping
