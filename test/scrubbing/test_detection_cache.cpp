#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/scrubbing/detection_cache.hpp"

namespace map_matcher::scrubbing {
namespace {

using std::chrono::milliseconds;
using testing::IsEmpty;
using testing::SizeIs;

DetectionSet setAt(Stamp stamp, const std::vector<Eigen::Vector3d>& positions = {{2.0, 0.0, 0.0}}) {
  DetectionSet set{"detector", "laser", stamp, {}};
  for (const Eigen::Vector3d& position : positions) {
    set.detections.push_back({position, 1.0});
  }
  return set;
}

std::optional<Eigen::Isometry3d> sameFrame(const DetectionSet& /*set*/) { return Eigen::Isometry3d::Identity(); }

class Cache : public testing::Test {
 protected:
  CacheOptions options;  // 0.25 s
  DetectionCache cache{options};
};

TEST_F(Cache, AppliesDetectionsToTheScansOfTheNextMoments) {
  cache.add(setAt(milliseconds(1000)));

  for (const int time : {1000, 1067, 1250}) {
    const std::vector<Disc>& discs = cache.discsAt(milliseconds(time), sameFrame);
    ASSERT_THAT(discs, SizeIs(1)) << time;
    EXPECT_EQ(discs[0].centre, Eigen::Vector2d(2.0, 0.0));
    EXPECT_EQ(discs[0].radius, 0.3);
  }
  EXPECT_THAT(cache.discsAt(milliseconds(1251), sameFrame), IsEmpty());
}

TEST_F(Cache, AppliesDetectionsOfAnotherLaserThatLookedALittleLater) {
  cache.add(setAt(milliseconds(1030)));

  EXPECT_THAT(cache.discsAt(milliseconds(1000), sameFrame), SizeIs(1));
  EXPECT_THAT(cache.discsAt(milliseconds(700), sameFrame), IsEmpty());
}

TEST_F(Cache, HoldsSeveralSetsAtOnce) {
  cache.add(setAt(milliseconds(1000), {{1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}));
  cache.add(setAt(milliseconds(1067), {}));
  cache.add(setAt(milliseconds(1133), {{3.0, 0.0, 0.0}}));

  EXPECT_THAT(cache.discsAt(milliseconds(1200), sameFrame), SizeIs(3));
}

TEST_F(Cache, ForgetsWhatNoLaterScanNeeds) {
  cache.add(setAt(milliseconds(1000)));
  cache.add(setAt(milliseconds(1200)));

  cache.forget(milliseconds(1300));

  EXPECT_EQ(cache.size(), 1U);
  cache.clear();
  EXPECT_EQ(cache.size(), 0U);
}

TEST_F(Cache, NeverGrowsWithoutEnd) {
  for (int i = 0; i < 10000; ++i) {
    cache.add(setAt(milliseconds(100000 + i)));  // after every scan, so that none is forgotten
    cache.forget(milliseconds(0));
  }

  EXPECT_LE(cache.size(), 256U);
}

TEST_F(Cache, MovesDetectionsWithTheRobot) {
  cache.add(setAt(milliseconds(1000), {{2.0, 0.0, 0.0}}));

  // Since then the laser drove 0.5 m ahead and turned left by a quarter.
  Eigen::Isometry3d T_then_now = Eigen::Isometry3d::Identity();
  T_then_now.translate(Eigen::Vector3d(0.5, 0.0, 0.0)).rotate(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ()));
  const std::vector<Disc>& discs =
      cache.discsAt(milliseconds(1100), [&](const DetectionSet& /*set*/) { return T_then_now.inverse(); });

  ASSERT_THAT(discs, SizeIs(1));
  EXPECT_NEAR(discs[0].centre.x(), 0.0, 1e-12);
  EXPECT_NEAR(discs[0].centre.y(), -1.5, 1e-12);
}

TEST_F(Cache, TurnsDetectionsOfALaserThatHangsUpsideDown) {
  cache.add(setAt(milliseconds(1000), {{2.0, 1.0, 0.0}}));
  Eigen::Isometry3d T_scan_set(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));

  const std::vector<Disc>& discs =
      cache.discsAt(milliseconds(1000), [&](const DetectionSet& /*set*/) { return T_scan_set; });

  ASSERT_THAT(discs, SizeIs(1));
  EXPECT_NEAR(discs[0].centre.y(), -1.0, 1e-12);
}

TEST_F(Cache, LeavesOutSetsWhosePoseIsNotKnown) {
  cache.add(setAt(milliseconds(1000)));

  EXPECT_THAT(cache.discsAt(milliseconds(1000), [](const DetectionSet& /*set*/) { return std::nullopt; }), IsEmpty());
}

TEST(GrowingCache, WidensTheCirclesWithAgeUpToALimit) {
  CacheOptions options;
  options.cache_duration = 1.0;
  options.radius_growth = 1.0;
  options.max_removal_radius = 0.5;
  DetectionCache cache(options);
  cache.add(setAt(milliseconds(1000)));

  EXPECT_NEAR(cache.discsAt(milliseconds(1000), sameFrame)[0].radius, 0.3, 1e-12);
  EXPECT_NEAR(cache.discsAt(milliseconds(1100), sameFrame)[0].radius, 0.4, 1e-12);
  EXPECT_NEAR(cache.discsAt(milliseconds(1900), sameFrame)[0].radius, 0.5, 1e-12);
}

TEST(GrowingCache, NeverMakesACircleSmallerThanTheRemovalRadius) {
  CacheOptions options;
  options.removal_radius = 0.8;
  options.max_removal_radius = 0.5;
  DetectionCache cache(options);
  cache.add(setAt(milliseconds(1000)));

  EXPECT_NEAR(cache.discsAt(milliseconds(1200), sameFrame)[0].radius, 0.8, 1e-12);
}

}  // namespace
}  // namespace map_matcher::scrubbing
