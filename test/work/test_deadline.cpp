#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "map_matcher/work/deadline.hpp"

namespace map_matcher::work {
namespace {

TEST(Deadline, PassesAtOnceWithoutTimeAndNeverWhenItIsInfinite) {
  EXPECT_TRUE(Deadline(0.0).passed());
  EXPECT_TRUE(Deadline(-1.0).passed());
  EXPECT_TRUE(Deadline(std::nan("")).passed());
  EXPECT_FALSE(Deadline(3600.0).passed());
  EXPECT_FALSE(Deadline(std::numeric_limits<double>::infinity()).passed());
  EXPECT_FALSE(Deadline().passed());
}

TEST(Deadline, PassesWithItsStopToken) {
  StopToken stop;
  const Deadline in_an_hour(3600.0, stop);

  stop.requestStop();

  EXPECT_TRUE(in_an_hour.passed());
  EXPECT_TRUE(in_an_hour.stopped());
  EXPECT_TRUE(in_an_hour.stop().stopRequested());
}

TEST(Deadline, IsWhatItsMakerTakesForTheEnd) {
  int looks = 0;
  const Deadline third_look([&looks] { return ++looks >= 3; });
  const Deadline copy = third_look;

  EXPECT_FALSE(third_look.passed());
  EXPECT_FALSE(copy.passed());
  EXPECT_TRUE(third_look.passed());
  EXPECT_TRUE(copy.passed());
  EXPECT_FALSE(copy.stopped());
}

TEST(Deadline, OfAnyKindIsEndedByItsStopToken) {
  StopToken stop;
  const Deadline never([] { return false; }, stop);
  ASSERT_FALSE(never.passed());

  stop.requestStop();

  EXPECT_TRUE(never.passed());
}

}  // namespace
}  // namespace map_matcher::work
