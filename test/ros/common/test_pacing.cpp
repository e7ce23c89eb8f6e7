#include <gtest/gtest.h>

#include "map_matcher/ros/common/pacing.hpp"

namespace map_matcher::ros_common {
namespace {

/// A real time [s].
Pacing::TimePoint at(double seconds) {
  return Pacing::TimePoint() +
         std::chrono::duration_cast<Pacing::TimePoint::duration>(std::chrono::duration<double>(seconds));
}

double secondsOf(const Pacing::TimePoint& time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

TEST(Pacing, countsFromTheFirstInstant) {
  Pacing pacing(1.0);
  EXPECT_NEAR(secondsOf(pacing.dueAfter(0.5, at(10.0))), 10.5, 1e-6);
  EXPECT_NEAR(secondsOf(pacing.dueAfter(0.5, at(10.5))), 11.0, 1e-6);
  EXPECT_EQ(pacing.lost(), 0.0);
}

TEST(Pacing, goesAsManyTimesFasterAsAskedFor) {
  Pacing pacing(4.0);
  pacing.dueAfter(0.0, at(10.0));
  for (int i = 1; i <= 10; ++i) {
    EXPECT_NEAR(secondsOf(pacing.dueAfter(1.0, at(10.0 + 0.25 * (i - 1)))), 10.0 + 0.25 * i, 1e-6);
  }
}

TEST(Pacing, makesUpForALittleDelay) {
  Pacing pacing(1.0);
  pacing.dueAfter(0.0, at(10.0));
  EXPECT_NEAR(secondsOf(pacing.dueAfter(0.1, at(10.25))), 10.1, 1e-6);  // late already: at once
  EXPECT_NEAR(secondsOf(pacing.dueAfter(0.1, at(10.25))), 10.2, 1e-6);
  EXPECT_NEAR(secondsOf(pacing.dueAfter(0.1, at(10.25))), 10.3, 1e-6);  // it has caught up
  EXPECT_EQ(pacing.lost(), 0.0);
}

TEST(Pacing, fallsBehindWhereEveryStepTakesTooLong) {
  Pacing pacing(1.0);
  pacing.dueAfter(0.0, at(0.0));
  double now = 0.0;
  for (int i = 0; i < 100; ++i) {  // each tenth of a second takes three
    now += 0.3;
    EXPECT_LE(secondsOf(pacing.dueAfter(0.1, at(now))), now);
  }
  EXPECT_NEAR(pacing.lost(), 20.0 - 0.2, 1e-6);
  // A fast machine again: no more than 0.2 s are made up for.
  EXPECT_NEAR(secondsOf(pacing.dueAfter(0.3, at(now))), now + 0.1, 1e-6);
}

TEST(Pacing, ofAFactorOfNoneWaitsForNothing) {
  Pacing pacing(0.0);
  EXPECT_NEAR(secondsOf(pacing.dueAfter(1000.0, at(3.0))), 3.0, 1e-6);
  EXPECT_NEAR(secondsOf(pacing.dueAfter(1000.0, at(3.1))), 3.1, 1e-6);
  EXPECT_EQ(pacing.lost(), 0.0);
}

}  // namespace
}  // namespace map_matcher::ros_common
