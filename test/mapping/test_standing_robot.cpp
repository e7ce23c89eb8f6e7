#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "map_matcher/mapping/session_mapper.hpp"
#include "support/room.hpp"
#include "support/walls.hpp"

namespace map_matcher::mapping {
namespace {

using test::distanceToWall;
using test::Room;
using test::scanFrom;
using test::wallsOf;

TEST(StandingRobot, GoesOnDrawingWhileTheRobotStands) {
  SessionMapperOptions options;
  options.temporal_update = 0.5;
  SessionMapper mapper(options);
  const auto outcomeAt = [&mapper](double time) { return mapper.addScan(time, {}, scanFrom({}, {}), {}).outcome; };

  EXPECT_EQ(outcomeAt(10.0), ScanOutcome::kDrawn);
  EXPECT_EQ(outcomeAt(10.4), ScanOutcome::kNotMoved);
  EXPECT_EQ(outcomeAt(10.5), ScanOutcome::kDrawn);
  EXPECT_EQ(outcomeAt(10.9), ScanOutcome::kNotMoved);
  EXPECT_EQ(outcomeAt(11.5), ScanOutcome::kDrawn);
}

/// Somebody who walks.
struct Walker {
  Eigen::Vector2d position{0.0, 0.0};
};

/// The scan of the room among walkers, each a disc with a radius of 0.25 m, that stand in the way of the beams.
scan::PlanarScan scanAmong(const std::vector<Walker>& walkers, const Room& room, const grid::Rigid2& pose) {
  constexpr double kRadius = 0.25;  // [m]
  scan::PlanarScan scan = scanFrom(room, pose);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double direction = pose.yaw + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Eigen::Vector2d beam(std::cos(direction), std::sin(direction));
    for (const Walker& walker : walkers) {
      const Eigen::Vector2d to_walker = walker.position - pose.translation();
      const double along = to_walker.dot(beam);
      const double beside = std::abs(to_walker.x() * beam.y() - to_walker.y() * beam.x());
      if (along > 0.0 && beside < kRadius) {
        const double range = along - std::sqrt(kRadius * kRadius - beside * beside);
        scan.ranges[i] = std::min(scan.ranges[i], static_cast<float>(range));
      }
    }
  }
  return scan;
}

/// Walkers around the robot, who come and go, and so many that they hide most of the room at every moment.
std::vector<Walker> walkersAt(double time) {
  std::vector<Walker> walkers;
  for (int k = 0; k < 9; ++k) {
    const double angle = 2.0 * M_PI * k / 9.0 + 0.5 * time;
    const double distance = 1.3 + 0.5 * std::sin(0.7 * time + 1.3 * k);
    walkers.push_back({{distance * std::cos(angle), distance * std::sin(angle)}});
  }
  return walkers;
}

TEST(StandingRobot, DrawsTheWallBehindWalkersWhileTheRobotStandsAmongThem) {
  const Room room;
  SessionMapper mapper;
  for (int k = 0; k < 15 * 20; ++k) {  // 20 s at 15 Hz
    const double time = k / 15.0;
    mapper.addScan(time, {}, scanAmong(walkersAt(time), room, {}), {});
  }

  int on_walls = 0;
  int elsewhere = 0;
  for (const Eigen::Vector2d& wall : wallsOf(*mapper.map())) {
    (distanceToWall(room, wall) < 0.08 ? on_walls : elsewhere) += 1;
  }
  SessionMapper alone;
  alone.addScan(0.0, {}, scanFrom(room, {}), {});
  const auto visible = static_cast<int>(wallsOf(*alone.map()).size());
  SessionMapper once;
  once.addScan(0.0, {}, scanAmong(walkersAt(0.0), room, {}), {});
  const std::vector<Eigen::Vector2d> at_first = wallsOf(*once.map());
  const auto on_walls_at_first = std::count_if(at_first.begin(), at_first.end(), [&room](const Eigen::Vector2d& wall) {
    return distanceToWall(room, wall) < 0.08;
  });
  EXPECT_LT(on_walls_at_first, visible / 2) << "the test is only worth something when walkers hide the walls";
  EXPECT_GT(on_walls, visible * 9 / 10);
  EXPECT_LT(elsewhere, visible / 20) << "walkers were drawn";
}

}  // namespace
}  // namespace map_matcher::mapping
