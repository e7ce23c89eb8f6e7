#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "map_matcher/scan/scan_merging.hpp"

namespace map_matcher::scan {
namespace {

constexpr double kHalfSide = 4.0;  // [m] of the room, a square around the origin
constexpr float kInf = std::numeric_limits<float>::infinity();

/// How far a beam goes in the room.
double rangeInRoom(const Eigen::Vector2d& from, double bearing) {
  const Eigen::Vector2d along(std::cos(bearing), std::sin(bearing));
  double nearest = 1e9;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(along[axis]) > 1e-12) {
      nearest = std::min(nearest, ((along[axis] > 0.0 ? kHalfSide : -kHalfSide) - from[axis]) / along[axis]);
    }
  }
  return nearest;
}

grid::Rigid2 between(const grid::Rigid2& first, const grid::Rigid2& last, double share) {
  return {first.x + share * (last.x - first.x), first.y + share * (last.y - first.y),
          first.yaw + share * (last.yaw - first.yaw)};
}

/// What a laser with a field of view of 270 degrees measures in the room, whose frame is the target's.
MovingScan measure(const grid::Rigid2& first, const grid::Rigid2& last, bool upside_down = false) {
  MovingScan moving;
  constexpr int kBeams = 811;
  moving.scan.angle_min = -0.75 * M_PI;
  moving.scan.angle_increment = 1.5 * M_PI / (kBeams - 1);
  moving.scan.range_min = 0.05;
  moving.scan.range_max = 20.0;
  moving.T_target_first = first;
  moving.T_target_last = last;
  moving.upside_down = upside_down;
  for (int beam = 0; beam < kBeams; ++beam) {
    const grid::Rigid2 pose = between(first, last, beam / (kBeams - 1.0));
    const double angle = moving.scan.angle_min + beam * moving.scan.angle_increment;
    moving.scan.ranges.push_back(
        static_cast<float>(rangeInRoom(pose.translation(), pose.yaw + (upside_down ? -angle : angle))));
  }
  return moving;
}

/// Every beam that has a range has that of the room, to what a beam's width makes of it.
void expectRoom(const PlanarScan& merged, std::size_t least) {
  std::size_t seen = 0;
  for (std::size_t beam = 0; beam < merged.ranges.size(); ++beam) {
    if (std::isfinite(merged.ranges[beam])) {
      ++seen;
      const double bearing = merged.angle_min + static_cast<double>(beam) * merged.angle_increment;
      std::vector<double> inside;
      for (const double side : {-0.5, 0.0, 0.5}) {  // a corner may be in the middle
        inside.push_back(rangeInRoom({0.0, 0.0}, bearing + side * merged.angle_increment));
      }
      EXPECT_GT(merged.ranges[beam], *std::min_element(inside.begin(), inside.end()) - 1e-4) << bearing;
      EXPECT_LT(merged.ranges[beam], *std::max_element(inside.begin(), inside.end()) + 1e-4) << bearing;
    }
  }
  EXPECT_GE(seen, least);
}

const grid::Rigid2 kFront{0.3, 0.1, 0.2};
const grid::Rigid2 kRear{-0.3, -0.1, 3.0};
const MergedLayout kLayout{720, 0.05, 20.0};

TEST(ScanMerging, SeesTheRoomAllRoundWithTwoLasers) {
  expectRoom(mergeScans({measure(kFront, kFront), measure(kRear, kRear)}, kLayout), 715);
}

TEST(ScanMerging, SeesWithOneLaserWhatThatOneSees) {
  const PlanarScan merged = mergeScans({measure(kFront, kFront)}, kLayout);

  expectRoom(merged, 500);
  EXPECT_GT(std::count(merged.ranges.begin(), merged.ranges.end(), kInf), 150);
}

TEST(ScanMerging, PutsEachBeamWhereTheLaserWasThen) {
  expectRoom(mergeScans(
                 {
                     measure(kFront, {0.4, 0.1, 0.35}),
                     measure(kRear, {-0.2, -0.1, 3.15}),
                 },
                 kLayout),
             700);
}

TEST(ScanMerging, TurnsOverTheTurnAlongTheShortWay) {
  MovingScan moving = measure({0.0, 0.0, 3.1}, {0.0, 0.0, 3.2});
  moving.T_target_last.yaw = 3.2 - 2.0 * M_PI;

  expectRoom(mergeScans({moving}, kLayout), 500);
}

TEST(ScanMerging, TakesALaserThatHangsUpsideDown) {
  expectRoom(mergeScans({measure(kFront, kFront, true), measure(kRear, kRear)}, kLayout), 715);
}

/// The slow, obvious way: for each beam, a look at all points.
TEST(ScanMerging, KeepsTheNearestPointOfEachBeam) {
  std::mt19937 random(1);
  std::vector<MovingScan> scans;
  std::vector<Eigen::Vector2d> points;
  for (const grid::Rigid2& pose : {kFront, kRear}) {
    MovingScan moving = measure(pose, pose);
    for (std::size_t beam = 0; beam < moving.scan.ranges.size(); ++beam) {
      moving.scan.ranges[beam] = static_cast<float>(0.5 + 1e-3 * static_cast<double>(random() % 5000));
      const double angle = moving.scan.angle_min + static_cast<double>(beam) * moving.scan.angle_increment;
      const auto range = static_cast<double>(moving.scan.ranges[beam]);
      points.push_back(pose * Eigen::Vector2d(range * std::cos(angle), range * std::sin(angle)));
    }
    scans.push_back(moving);
  }

  const PlanarScan merged = mergeScans(scans, {90, 0.0, 20.0});

  for (std::size_t beam = 0; beam < merged.ranges.size(); ++beam) {
    const double bearing = merged.angle_min + static_cast<double>(beam) * merged.angle_increment;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& point : points) {
      const double off = std::remainder(std::atan2(point.y(), point.x()) - bearing, 2.0 * M_PI);
      if (std::abs(off) <= 0.5 * merged.angle_increment) {
        nearest = std::min(nearest, point.norm());
      }
    }
    EXPECT_FLOAT_EQ(merged.ranges[beam], static_cast<float>(nearest)) << bearing;
  }
}

TEST(ScanMerging, ShowsNothingWhereNothingWasMeasured) {
  MovingScan moving = measure(kFront, kFront);
  const float nothing[] = {kInf, std::numeric_limits<float>::quiet_NaN(), 0.0F, 21.0F, -1.0F};
  for (std::size_t beam = 0; beam < moving.scan.ranges.size(); ++beam) {
    moving.scan.ranges[beam] = nothing[beam % 5];
  }

  const PlanarScan merged = mergeScans({moving}, kLayout);

  EXPECT_EQ(std::count(merged.ranges.begin(), merged.ranges.end(), kInf), 720);
}

TEST(ScanMerging, LeavesOutWhatIsTooNearOrTooFar) {
  const PlanarScan merged = mergeScans({measure(kFront, kFront), measure(kRear, kRear)}, {720, 4.5, 5.0});

  for (const float range : merged.ranges) {
    EXPECT_TRUE(range == kInf || (range >= 4.5F && range <= 5.0F)) << range;
  }
}

TEST(ScanMerging, RefusesScansAndLayoutsThatMakeNoSense) {
  MovingScan moving = measure(kFront, kFront);
  moving.scan.angle_increment = 0.0;

  EXPECT_THROW(mergeScans({moving}, kLayout), std::invalid_argument);
  EXPECT_THROW(mergeScans({}, {7, 0.05, 20.0}), std::invalid_argument);
  EXPECT_THROW(mergeScans({}, {720, 20.0, 20.0}), std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher::scan
