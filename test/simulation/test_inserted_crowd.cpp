#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "map_matcher/simulation/inserted_crowd.hpp"
#include "support/drives.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kBeams = 361;
constexpr double kDegree = M_PI / 180.0;
const grid::Rigid2 kRobot{1.5, 2.0, 0.3};  // stands in the left one of the two rooms

InsertedCrowdOptions crowdOptions(int people = 4) {
  InsertedCrowdOptions options;
  options.pedestrians.people = people;
  options.pedestrians.standing_share = 0.0;
  options.sigma = 0.0;
  options.detector.recall = 0.99;
  options.detector.position_sigma = 0.0;
  return options;
}

/// A scan that measured 6 m everywhere, beyond the rooms.
scan::MountedScan openScan() {
  return {{{-180.0 * kDegree, kDegree, 0.05, 20.0}, std::vector<float>(kBeams, 6.0F)}, {{0.1, 0.0, 0.0}, false}};
}

Eigen::Vector2d pointOf(const scan::PlanarScan& scan, const grid::Rigid2& T_map_laser, std::size_t beam) {
  const double angle = scan.angle_min + static_cast<double>(beam) * scan.angle_increment;
  const double range = scan.ranges[beam];
  return T_map_laser * Eigen::Vector2d(range * std::cos(angle), range * std::sin(angle));
}

double distanceToLegs(const std::vector<Person>& people, const Eigen::Vector2d& p) {
  double nearest = 1e9;
  for (const Circle& leg : legsOf(people)) {
    nearest = std::min(nearest, std::abs((leg.centre - p).norm() - leg.radius));
  }
  return nearest;
}

TEST(InsertedCrowd, ShowsLegsWherePeopleStandAndLeavesAllElseAsItWas) {
  InsertedCrowd crowd(test::twoRooms(), crowdOptions());
  const scan::MountedScan recorded = openScan();
  int changed = 0;
  for (int i = 0; i < 20; ++i) {
    crowd.moveOn(100.0 + 0.2 * i, {kRobot});
    const scan::PlanarScan scan = crowd.among(recorded).scan;
    ASSERT_EQ(scan.ranges.size(), recorded.scan.ranges.size());
    for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
      if (scan.ranges[k] != recorded.scan.ranges[k]) {
        ++changed;
        EXPECT_LT(scan.ranges[k], 6.0F);
        EXPECT_LT(distanceToLegs(crowd.people(), pointOf(scan, kRobot * recorded.mount.T_base_laser, k)), 1e-3);
      }
    }
  }
  EXPECT_EQ(crowd.people().size(), 4U);
  EXPECT_GT(changed, 100);
}

TEST(InsertedCrowd, IsHiddenBehindWhatWasRecordedBeforeIt) {
  InsertedCrowd crowd(test::twoRooms(), crowdOptions());
  scan::MountedScan recorded = openScan();
  recorded.scan.ranges.assign(kBeams, 0.2F);

  crowd.moveOn(100.0, {kRobot});
  const CrowdedScan crowded = crowd.among(recorded);

  EXPECT_EQ(crowded.scan.ranges, recorded.scan.ranges);
  ASSERT_TRUE(crowded.detections.has_value());
  for (const DetectedPerson& person : crowded.detections->people) {
    EXPECT_LT(person.score, 1.0);  // false alarms at most
    EXPECT_LT(person.position.norm(), 0.6);
  }
}

/// Whoever is detected with certainty stands there.
TEST(InsertedCrowd, IsDetectedInTheFrameOfTheLaserHoweverItIsMounted) {
  for (const bool upside_down : {false, true}) {
    InsertedCrowd crowd(test::twoRooms(), crowdOptions());
    scan::MountedScan recorded = openScan();
    recorded.mount = {{0.1, 0.05, 0.7}, upside_down};
    int detected = 0;
    for (int i = 0; i < 20; ++i) {
      crowd.moveOn(100.0 + 0.2 * i, {kRobot});
      const CrowdedScan crowded = crowd.among(recorded);
      ASSERT_TRUE(crowded.detections.has_value());
      EXPECT_DOUBLE_EQ(crowded.detections->time, 100.0 + 0.2 * i);
      for (const DetectedPerson& found : crowded.detections->people) {
        Eigen::Vector2d in_laser = found.position;
        in_laser.y() *= upside_down ? -1.0 : 1.0;
        const Eigen::Vector2d position = kRobot * recorded.mount.T_base_laser * in_laser;
        for (const Person& person : crowd.people()) {
          detected += (person.position - position).norm() < 0.01 ? 1 : 0;
        }
      }
    }
    EXPECT_GT(detected, 15) << "upside down: " << upside_down;
  }
}

TEST(InsertedCrowd, SeenByALaserThatHangsUpsideDownIsMirrored) {
  InsertedCrowd crowd(test::twoRooms(), crowdOptions());
  InsertedCrowd same(test::twoRooms(), crowdOptions());
  scan::MountedScan upright = openScan();
  scan::MountedScan hanging = openScan();
  hanging.mount.upside_down = true;

  crowd.moveOn(100.0, {kRobot});
  same.moveOn(100.0, {kRobot});
  const std::vector<float> seen = crowd.among(upright).scan.ranges;
  std::vector<float> mirrored = same.among(hanging).scan.ranges;

  std::reverse(mirrored.begin(), mirrored.end());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NEAR(seen[i], mirrored[i], 1e-3) << i;
  }
}

TEST(InsertedCrowd, IsTheSameForTheSameSeedOnly) {
  const auto ranges_of = [](std::uint64_t seed) {
    InsertedCrowdOptions options = crowdOptions();
    options.seed = seed;
    options.sigma = 0.03;
    InsertedCrowd crowd(test::twoRooms(), options);
    std::vector<float> ranges;
    for (int i = 0; i < 10; ++i) {
      crowd.moveOn(100.0 + 0.2 * i, {kRobot});
      const scan::PlanarScan scan = crowd.among(openScan()).scan;
      ranges.insert(ranges.end(), scan.ranges.begin(), scan.ranges.end());
    }
    return ranges;
  };
  EXPECT_EQ(ranges_of(1), ranges_of(1));
  EXPECT_NE(ranges_of(1), ranges_of(2));
}

TEST(InsertedCrowd, KeepsOutOfTheWayOfTheRobot) {
  InsertedCrowd crowd(test::twoRooms(), crowdOptions(6));
  double nearest = 1e9;
  for (int i = 0; i < 200; ++i) {
    crowd.moveOn(100.0 + 0.1 * i, {kRobot, {kRobot.x + 0.25, kRobot.y, 0.0}});
    for (const Person& person : crowd.people()) {
      nearest = std::min(nearest, (person.position - kRobot.translation()).norm());
    }
  }
  EXPECT_GT(nearest, 0.25 + 0.1);
}

TEST(InsertedCrowd, IsNotSeenFromWithin) {
  InsertedCrowd crowd(test::twoRooms(), crowdOptions());
  crowd.moveOn(100.0, {kRobot});
  const Eigen::Vector2d place = crowd.people().front().position;
  crowd.moveOn(100.001, {{place.x(), place.y(), 0.0}});  // the robot has driven into somebody

  scan::MountedScan recorded = openScan();
  recorded.mount = {};
  for (const float range : crowd.among(recorded).scan.ranges) {
    EXPECT_GT(range, 0.25F);
  }
}

TEST(InsertedCrowd, MovesOnOnlySoFarInALongGap) {
  InsertedCrowd crowd(test::twoRooms(), crowdOptions());
  crowd.moveOn(100.0, {kRobot});
  crowd.moveOn(1e6, {kRobot});
  crowd.moveOn(50.0, {kRobot});  // time went back
  EXPECT_EQ(crowd.people().size(), 4U);
}

TEST(InsertedCrowd, NamesEveryBadOption) {
  InsertedCrowdOptions options = crowdOptions();
  options.robot_radius = -1.0;
  options.pedestrians.density = 9.0;

  EXPECT_THAT(test::thrownText<std::invalid_argument>([&] { InsertedCrowd(test::twoRooms(), options); }),
              AllOf(HasSubstr("radius is -1"), HasSubstr("density is 9, expected 0 to 3")));
}

}  // namespace
}  // namespace map_matcher::simulation
