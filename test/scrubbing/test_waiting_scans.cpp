#include <gtest/gtest.h>

#include <vector>

#include "map_matcher/scrubbing/waiting_scans.hpp"

namespace map_matcher::scrubbing {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Stamp kNow = seconds(100);

class Waiting : public testing::Test {
 protected:
  void add(Stamp stamp, Stamp now) { scans.add({"laser", stamp, {}, nullptr}, now, nullptr); }

  std::vector<WaitingScans::Released> release(Stamp now) {
    std::vector<WaitingScans::Released> released;
    while (auto next = scans.release(now)) {
      released.push_back(*next);
    }
    return released;
  }

  WaitingScans scans{milliseconds(100)};
};

TEST_F(Waiting, HoldsAScanUntilItsDetectionsAreThere) {
  add(seconds(5), kNow);
  EXPECT_TRUE(release(kNow).empty());

  scans.onDetections("laser", seconds(5));

  const auto released = release(kNow);
  ASSERT_EQ(released.size(), 1U);
  EXPECT_TRUE(released[0].answered);
  EXPECT_TRUE(release(kNow + seconds(1)).empty());
}

TEST_F(Waiting, LetsAScanGoAtOnceWhoseDetectionsCameBefore) {
  scans.onDetections("laser", seconds(5));
  add(seconds(5), kNow);

  EXPECT_EQ(release(kNow).size(), 1U);
}

TEST_F(Waiting, IsNotFooledByDetectionsOfAnotherScanOrLaser) {
  add(seconds(5), kNow);

  scans.onDetections("laser", seconds(5) + std::chrono::microseconds(1));
  scans.onDetections("rear_laser", seconds(5));

  EXPECT_TRUE(release(kNow).empty());
}

TEST_F(Waiting, LetsAScanGoWhenItWaitedLongEnough) {
  add(seconds(5), kNow);

  EXPECT_TRUE(release(kNow + milliseconds(99)).empty());
  const auto released = release(kNow + milliseconds(100));
  ASSERT_EQ(released.size(), 1U);
  EXPECT_FALSE(released[0].answered);
}

TEST_F(Waiting, LetsNoScanOvertakeAnother) {
  add(milliseconds(5000), kNow);
  add(milliseconds(5100), kNow + milliseconds(50));
  scans.onDetections("laser", milliseconds(5100));

  EXPECT_TRUE(release(kNow + milliseconds(60)).empty());
  const auto released = release(kNow + milliseconds(100));
  ASSERT_EQ(released.size(), 2U);
  EXPECT_EQ(released[0].scan.stamp, milliseconds(5000));
  EXPECT_TRUE(released[1].answered);
}

TEST_F(Waiting, NeverHoldsScansWithoutEnd) {
  std::size_t num_released = 0;
  for (int i = 0; i < 1000; ++i) {
    add(seconds(5 + i), kNow);
    num_released += release(kNow).size();
  }

  EXPECT_GE(num_released, 900U);
}

}  // namespace
}  // namespace map_matcher::scrubbing
