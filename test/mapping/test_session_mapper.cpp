#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "map_matcher/mapping/session_mapper.hpp"
#include "support/room.hpp"
#include "support/walls.hpp"

namespace map_matcher::mapping {
namespace {

using test::distanceToWall;
using test::kNumBeams;
using test::noisy;
using test::Room;
using test::scanFrom;
using test::wallsOf;

/// Drives along a curve through the room with perfect odometry.
void drive(SessionMapper& mapper, const Room& room, const scan::LaserMount& mount = {}) {
  for (int i = 0; i <= 40; ++i) {
    const grid::Rigid2 pose{-1.0 + 0.05 * i, 0.3 * std::sin(0.15 * i), 0.03 * i};
    mapper.addScan(0.1 * i, pose, scanFrom(room, pose, mount), mount);
  }
}

TEST(SessionMapper, HasNoMapBeforeTheFirstScan) {
  const SessionMapper mapper;

  EXPECT_FALSE(mapper.hasMap());
  EXPECT_EQ(mapper.map(), std::nullopt);
}

TEST(SessionMapper, DrawsTheFirstScanInTheOdometryFrame) {
  SessionMapper mapper;
  const grid::Rigid2 odometry{0.5, -0.25, 1.0};

  const ScanReport report = mapper.addScan(0.0, odometry, scanFrom({}, odometry), {});

  EXPECT_EQ(report.outcome, ScanOutcome::kDrawn);
  EXPECT_EQ(report.hits, kNumBeams);
  EXPECT_NEAR(mapper.T_session_base().x, 0.5, 1e-12);
  EXPECT_NEAR(mapper.T_session_odom().x, 0.0, 1e-12);
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    EXPECT_LE(distanceToWall({}, wall), 0.5 * 0.05 + 1e-6) << wall.transpose();
  }
}

TEST(SessionMapper, PutsEveryWallIntoTheCellThatHoldsIt) {
  const Room room;  // x = 4.02 lies in the cell [4.00, 4.05), y = 2.52 in [2.50, 2.55)
  SessionMapper mapper;

  drive(mapper, room);

  const grid::OccupancyGrid map = *mapper.map();
  const std::vector<Eigen::Vector2d> walls = wallsOf(map);
  EXPECT_GT(walls.size(), 400U);
  for (const Eigen::Vector2d& wall : walls) {
    EXPECT_LE(distanceToWall(room, wall), 0.05 + 0.02) << wall.transpose() << ": a cell of 5 cm beside its wall";
  }
}

TEST(SessionMapper, DrawsWallsWithoutAHalfCellError) {
  const Room room;
  SessionMapper mapper;

  drive(mapper, room);

  // The mean of the signed distances of the cells' centres to a wall in the middle of a cell: half a cell would show as
  // 0.025 m.
  double sum_x = 0.0;
  double sum_y = 0.0;
  int num_x = 0;
  int num_y = 0;
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    if (std::abs(wall.x() - room.right) < 0.1 && std::abs(wall.y()) < 1.5) {
      sum_x += wall.x() - room.right;
      ++num_x;
    }
    if (std::abs(wall.y() - room.upper) < 0.1 && std::abs(wall.x()) < 2.5) {
      sum_y += wall.y() - room.upper;
      ++num_y;
    }
  }
  ASSERT_GT(num_x, 30);
  ASSERT_GT(num_y, 30);
  EXPECT_NEAR(sum_x / num_x, 4.025 - room.right, 0.01);
  EXPECT_NEAR(sum_y / num_y, 2.525 - room.upper, 0.01);
}

TEST(SessionMapper, TakesTheMountOfTheLaserIntoAccount) {
  const Room room;
  for (const bool upside_down : {false, true}) {
    SessionMapper mapper;

    drive(mapper, room, {{0.25, -0.1, 0.7}, upside_down});

    const auto walls = wallsOf(*mapper.map());
    EXPECT_GT(walls.size(), 400U);
    for (const Eigen::Vector2d& wall : walls) {
      EXPECT_LE(distanceToWall(room, wall), 0.05 + 0.02) << wall.transpose() << ", upside down: " << upside_down;
    }
  }
}

TEST(SessionMapper, CorrectsOdometryThatDrifts) {
  const Room room;
  SessionMapper mapper;
  grid::Rigid2 truth{-1.0, 0.0, 0.0};
  grid::Rigid2 odometry = truth;
  const grid::Rigid2 true_step{0.05, 0.0, 0.02};
  const grid::Rigid2 measured_step{0.055, 0.001, 0.023};

  mapper.addScan(0.0, odometry, scanFrom(room, truth), {});
  for (int i = 0; i < 60; ++i) {
    truth = truth * true_step;
    odometry = odometry * measured_step;
    mapper.addScan(0.1 * i, odometry, scanFrom(room, truth), {});
  }

  const grid::Rigid2 error = truth.inverse() * mapper.T_session_base();
  const grid::Rigid2 odometry_error = truth.inverse() * odometry;
  EXPECT_GT(odometry_error.translation().norm(), 0.2) << "the test is only worth something when odometry is bad";
  EXPECT_LT(error.translation().norm(), 0.03);
  EXPECT_LT(std::abs(error.yaw), 0.01);
  const grid::Rigid2 composed = mapper.T_session_odom() * odometry;
  EXPECT_NEAR(composed.x, mapper.T_session_base().x, 1e-9);
  EXPECT_NEAR(composed.yaw, mapper.T_session_base().yaw, 1e-9);
}

TEST(SessionMapper, MapsFarFromTheOriginOfOdometryAsWellAsNearIt) {
  const Room room{-3.0 + 50'000.0, 4.02 + 50'000.0, -2.0, 2.52};
  SessionMapper mapper;

  for (int i = 0; i <= 40; ++i) {
    const grid::Rigid2 pose{49'999.0 + 0.05 * i, 0.0, 0.03 * i};
    mapper.addScan(0.1 * i, pose, scanFrom(room, pose), {});
  }

  const grid::Rigid2 error = grid::Rigid2{50'001.0, 0.0, 1.2}.inverse() * mapper.T_session_base();
  EXPECT_LT(error.translation().norm(), 0.01);
}

TEST(SessionMapper, LooksAtNoScanWhileTheRobotStandsWhereTimeDoesNotCount) {
  SessionMapperOptions options;
  options.temporal_update = -1.0;
  SessionMapper mapper(options);
  const grid::Rigid2 pose{0.0, 0.0, 0.0};
  mapper.addScan(0.0, pose, scanFrom({}, pose), {});
  const auto before = mapper.map()->values();

  const ScanReport report = mapper.addScan(1e6, pose, scanFrom({-1.0, 1.0, -1.0, 1.0}, pose), {});

  EXPECT_EQ(report.outcome, ScanOutcome::kNotMoved);
  EXPECT_EQ(mapper.map()->values(), before);
}

TEST(SessionMapper, DrawsAScanOnlyAfterTheMotionAskedFor) {
  SessionMapperOptions options;
  options.linear_update = 0.5;
  SessionMapper mapper(options);
  const auto outcomeAt = [&mapper](double x) {
    const grid::Rigid2 pose{x, 0.0, 0.0};
    return mapper.addScan(0.0, pose, scanFrom({}, pose), {}).outcome;  // at once, so that time alone draws nothing
  };

  EXPECT_EQ(outcomeAt(0.0), ScanOutcome::kDrawn);
  EXPECT_EQ(outcomeAt(0.05), ScanOutcome::kNotMoved);
  EXPECT_EQ(outcomeAt(0.2), ScanOutcome::kMatched);
  EXPECT_EQ(outcomeAt(0.45), ScanOutcome::kMatched);
  EXPECT_EQ(outcomeAt(0.55), ScanOutcome::kDrawn);
}

TEST(SessionMapper, IgnoresBeamsThatSayNothing) {
  SessionMapper mapper;
  const grid::Rigid2 pose;
  scan::PlanarScan scan = scanFrom({}, pose);
  for (std::size_t i = 0; i < scan.ranges.size(); i += 2) {
    scan.ranges[i] = i % 4 == 0 ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
  }

  const ScanReport report = mapper.addScan(0.0, pose, scan, {});

  EXPECT_EQ(report.hits, kNumBeams / 2);
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    EXPECT_LE(distanceToWall({}, wall), 0.05) << wall.transpose();
  }
}

TEST(SessionMapper, FollowsTheOdometryWhileNoBeamEndsAtAWall) {
  SessionMapper mapper;
  mapper.addScan(0.0, {}, scanFrom({}, {}), {});
  scan::PlanarScan blind = scanFrom({}, {});
  std::fill(blind.ranges.begin(), blind.ranges.end(), std::numeric_limits<float>::infinity());

  const ScanReport report = mapper.addScan(2.0, {1.0, 0.0, 0.0}, blind, {});

  EXPECT_EQ(report.outcome, ScanOutcome::kTooFewHits);
  EXPECT_NEAR(mapper.T_session_base().x, 1.0, 1e-12);
}

TEST(SessionMapper, DoesNotStartWithAScanThatShowsNoWall) {
  SessionMapper mapper;
  scan::PlanarScan blind = scanFrom({}, {});
  std::fill(blind.ranges.begin(), blind.ranges.end(), std::numeric_limits<float>::infinity());

  EXPECT_EQ(mapper.addScan(0.0, {}, blind, {}).outcome, ScanOutcome::kTooFewHits);
  EXPECT_FALSE(mapper.hasMap());
}

TEST(SessionMapper, DrawsWhatSeveralLasersSeeIntoOneMap) {
  const Room room;
  const scan::LaserMount front{{0.25, 0.0, 0.0}, false};
  const scan::LaserMount rear{{-0.25, 0.0, M_PI}, false};
  scan::PlanarScan blind = scanFrom(room, {});
  std::fill(blind.ranges.begin(), blind.ranges.end(), std::numeric_limits<float>::infinity());
  for (const bool rear_sees : {true, false}) {
    SessionMapper mapper;
    for (int i = 0; i <= 10; ++i) {
      const grid::Rigid2 pose{0.05 * i, 0.0, 0.0};
      mapper.addScan(0.1 * i, pose, scanFrom(room, pose, front), front, 0);
      mapper.addScan(0.1 * i, pose, rear_sees ? scanFrom(room, pose, rear) : blind, rear, 1);
    }

    int behind = 0;
    for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
      EXPECT_LE(distanceToWall(room, wall), 0.07) << wall.transpose() << ", rear laser sees: " << rear_sees;
      behind += wall.x() < -2.9 && std::abs(wall.y()) < 1.0 ? 1 : 0;
    }
    if (rear_sees) {
      EXPECT_GT(behind, 35);
    } else {
      EXPECT_EQ(behind, 0);
    }
    EXPECT_NEAR(mapper.T_session_base().x, 0.5, 0.01);
  }
}

TEST(SessionMapper, DrawsTheSameMapOfTheSameScans) {
  const auto map_of = [] {
    std::mt19937 generator(7);
    SessionMapper mapper;
    for (int i = 0; i <= 60; ++i) {
      const grid::Rigid2 pose{-1.0 + 0.03 * i, 0.1 * std::sin(0.2 * i), 0.05 * i};
      mapper.addScan(0.1 * i, pose, noisy(scanFrom({}, pose), 0.03, generator), {});
    }
    return mapper.map()->values();
  };

  EXPECT_EQ(map_of(), map_of());
}

TEST(SessionMapper, AcceptsScansWithAnotherNumberOfBeams) {
  SessionMapper mapper;
  mapper.addScan(0.0, {}, scanFrom({}, {}), {});
  const grid::Rigid2 moved{0.4, 0.0, 0.0};
  scan::PlanarScan half = scanFrom({}, moved);
  half.ranges.resize(half.ranges.size() / 2);

  EXPECT_EQ(mapper.addScan(1.0, moved, half, {}).outcome, ScanOutcome::kDrawn);
}

TEST(SessionMapper, BeginsANewSessionAfterReset) {
  SessionMapper mapper;
  drive(mapper, {});
  const grid::Rigid2 elsewhere{7.0, 8.0, 2.0};

  mapper.reset();

  EXPECT_FALSE(mapper.hasMap());
  const Room small{6.0, 8.0, 7.0, 9.0};
  EXPECT_EQ(mapper.addScan(0.0, elsewhere, scanFrom(small, elsewhere), {}).outcome, ScanOutcome::kDrawn);
  EXPECT_NEAR(mapper.T_session_base().x, 7.0, 1e-12);
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    EXPECT_LE(distanceToWall(small, wall), 0.05) << wall.transpose();
  }
}

TEST(SessionMapper, DrawsASmallMapHoweverFarOffOdometryBegins) {
  for (const double far : {50.0, 5e4, 1e7}) {
    SessionMapper mapper;
    const grid::Rigid2 odometry{far, -2.0 * far, 0.5};
    const Room room{far - 5.0, far + 4.0, -2.0 * far - 3.0, -2.0 * far + 4.5};

    EXPECT_EQ(mapper.addScan(0.0, odometry, scanFrom(room, odometry), {}).outcome, ScanOutcome::kDrawn);

    const grid::OccupancyGrid map = *mapper.map();
    EXPECT_NEAR(map.width(), 400, 1) << far;
    EXPECT_NEAR(map.height(), 400, 1) << far;
    for (const Eigen::Vector2d& wall : wallsOf(map)) {
      EXPECT_LE(distanceToWall(room, wall), 0.05) << wall.transpose();
    }
  }
}

TEST(SessionMapper, IsAsBeforeAfterABadScanOrPose) {
  SessionMapper mapper;
  mapper.addScan(0.0, {}, scanFrom({}, {}), {});
  const auto before = mapper.map()->values();
  scan::PlanarScan bad = scanFrom({}, {});
  bad.range_max = std::numeric_limits<double>::quiet_NaN();

  EXPECT_THROW(mapper.addScan(0.0, {5.0, 0.0, 0.0}, bad, {}), std::invalid_argument);
  EXPECT_THROW(mapper.addScan(std::nan(""), {}, scanFrom({}, {}), {}), std::invalid_argument);
  EXPECT_THROW(mapper.addScan(0.0, {std::nan(""), 0.0, 0.0}, scanFrom({}, {}), {}), std::invalid_argument);

  EXPECT_EQ(mapper.map()->values(), before);
  EXPECT_NEAR(mapper.T_session_base().x, 0.0, 1e-12);
}

TEST(SessionMapper, NamesEveryOptionOutOfRange) {
  SessionMapperOptions options;
  options.delta = -1.0;
  options.occ_thresh = 1.5;
  options.xmin = 20.0;
  options.max_range = 5.0;
  options.max_urange = 6.0;
  try {
    const SessionMapper mapper(options);
    FAIL() << "expected an error";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("delta is -1, expected 0.001 to 1 m"), std::string::npos) << text;
    EXPECT_NE(text.find("occ_thresh is 1.5, expected 0 to 1"), std::string::npos) << text;
    EXPECT_NE(text.find("xmin is 20, expected less than xmax = 10"), std::string::npos) << text;
    EXPECT_NE(text.find("maxUrange is 6, expected at most maxRange = 5"), std::string::npos) << text;
  }
}

TEST(SessionMapper, RefusesAFirstMapThatIsTooLarge) {
  SessionMapperOptions options;
  options.delta = 0.001;
  options.xmin = -1000.0;
  options.xmax = 1000.0;

  EXPECT_THROW(SessionMapper{options}, std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher::mapping
