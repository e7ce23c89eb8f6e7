#include <gtest/gtest.h>

#include "map_matcher/ros/common/rising_clock.hpp"

namespace map_matcher::ros_common {
namespace {

using Tick = RisingClock::Tick;

TEST(RisingClock, HoldsBeforeTheFirstClock) { EXPECT_EQ(RisingClock().tick(ros::Time(0.0)), Tick::kHeld); }

TEST(RisingClock, AdvancesOnlyWhenTimeIsLater) {
  RisingClock clock;

  EXPECT_EQ(clock.tick(ros::Time(10.0)), Tick::kAdvanced);
  EXPECT_EQ(clock.tick(ros::Time(10.0)), Tick::kHeld);
  EXPECT_EQ(clock.tick(ros::Time(10.05)), Tick::kAdvanced);
}

TEST(RisingClock, WaitsForTimeThatWasSetRightALittle) {
  RisingClock clock;
  clock.tick(ros::Time(10.0));

  EXPECT_EQ(clock.tick(ros::Time(9.5)), Tick::kHeld);
  EXPECT_EQ(clock.tick(ros::Time(10.0)), Tick::kHeld);
  EXPECT_EQ(clock.tick(ros::Time(10.1)), Tick::kAdvanced);
}

TEST(RisingClock, TellsOnceThatTimeWentBackAndStartsAnewFromThere) {
  RisingClock clock;
  clock.tick(ros::Time(100.0));

  EXPECT_EQ(clock.tick(ros::Time(10.0)), Tick::kWentBack);
  EXPECT_EQ(clock.tick(ros::Time(10.0)), Tick::kHeld);
  EXPECT_EQ(clock.tick(ros::Time(10.1)), Tick::kAdvanced);
}

}  // namespace
}  // namespace map_matcher::ros_common
