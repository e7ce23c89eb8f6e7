#include <gtest/gtest.h>

#include "map_matcher/ros/common/stamps.hpp"

namespace map_matcher::ros_common {
namespace {

TEST(Stamps, LieApartByTheSecondsBetweenThem) {
  EXPECT_EQ(secondsBetween(ros::Time(10, 250'000'000), ros::Time(10, 750'000'000)), 0.5);
  EXPECT_EQ(secondsBetween(ros::Time(10, 750'000'000), ros::Time(9, 250'000'000)), -1.5);
}

TEST(Stamps, MayLieApartFurtherThanADurationGoes) {
  EXPECT_EQ(secondsBetween(ros::Time(10, 0), ros::Time(4'000'000'010U, 0)), 4e9);
  EXPECT_EQ(secondsBetween(ros::Time(4'000'000'010U, 0), ros::Time(10, 0)), -4e9);
}

}  // namespace
}  // namespace map_matcher::ros_common
