#include <gtest/gtest.h>
#include <ros/time.h>

#include <new>
#include <stdexcept>

#include "map_matcher/ros/common/callback_guard.hpp"

namespace map_matcher::ros_common {
namespace {

TEST(CallbackGuard, LetsNoExceptionOutAndCountsIt) {
  ros::Time::init();  // for the log
  CallbackGuard guard;

  EXPECT_FALSE(guard.run("scan", [] { throw std::runtime_error("no such thing"); }));
  EXPECT_EQ(guard.lastFailure(), "scan: no such thing");
  EXPECT_FALSE(guard.run("map", [] { throw std::bad_alloc(); }));
  EXPECT_FALSE(guard.run("map", [] { throw 1; }));
  EXPECT_EQ(guard.failures(), 3);
}

TEST(CallbackGuard, TellsThatAllWentWell) {
  CallbackGuard guard;
  bool is_done = false;

  EXPECT_TRUE(guard.run("scan", [&is_done] { is_done = true; }));
  EXPECT_TRUE(is_done);
  EXPECT_EQ(guard.failures(), 0);
}

}  // namespace
}  // namespace map_matcher::ros_common
