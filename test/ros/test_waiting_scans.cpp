#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "map_matcher/ros/detection_messages.hpp"
#include "map_matcher/ros/waiting_scans.hpp"

namespace map_matcher {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const ros::SteadyTime kNow(100, 0);

sensor_msgs::LaserScanConstPtr scanAt(double stamp, const std::string& frame = "laser") {
  auto scan = boost::make_shared<sensor_msgs::LaserScan>();
  scan->header.frame_id = frame;
  scan->header.stamp = ros::Time(stamp);
  return scan;
}

class Waiting : public testing::Test {
 protected:
  WaitingScans scans{ros::WallDuration(0.1)};
};

TEST_F(Waiting, HoldsAScanUntilItsDetectionsAreThere) {
  scans.add(scanAt(5.0), kNow);
  EXPECT_THAT(scans.release(kNow), IsEmpty());

  scans.onDetections("laser", stampOf(ros::Time(5.0)));

  const auto released = scans.release(kNow);
  ASSERT_THAT(released, SizeIs(1));
  EXPECT_TRUE(released[0].answered);
  EXPECT_TRUE(scans.empty());
}

TEST_F(Waiting, LetsAScanGoAtOnceWhoseDetectionsCameBefore) {
  scans.onDetections("laser", stampOf(ros::Time(5.0)));
  scans.add(scanAt(5.0, "/laser"), kNow);

  EXPECT_THAT(scans.release(kNow), SizeIs(1));
}

TEST_F(Waiting, IsNotFooledByDetectionsOfAnotherScanOrLaser) {
  scans.add(scanAt(5.0), kNow);

  scans.onDetections("laser", stampOf(ros::Time(5.000001)));
  scans.onDetections("rear_laser", stampOf(ros::Time(5.0)));

  EXPECT_THAT(scans.release(kNow), IsEmpty());
}

TEST_F(Waiting, LetsAScanGoWhenItWaitedLongEnough) {
  scans.add(scanAt(5.0), kNow);

  EXPECT_THAT(scans.release(kNow + ros::WallDuration(0.099)), IsEmpty());
  const auto released = scans.release(kNow + ros::WallDuration(0.1));
  ASSERT_THAT(released, SizeIs(1));
  EXPECT_FALSE(released[0].answered);
}

TEST_F(Waiting, LetsNoScanOvertakeAnother) {
  scans.add(scanAt(5.0), kNow);
  scans.add(scanAt(5.1), kNow + ros::WallDuration(0.05));
  scans.onDetections("laser", stampOf(ros::Time(5.1)));

  EXPECT_THAT(scans.release(kNow + ros::WallDuration(0.06)), IsEmpty());
  const auto released = scans.release(kNow + ros::WallDuration(0.1));
  ASSERT_THAT(released, SizeIs(2));
  EXPECT_EQ(released[0].scan->header.stamp, ros::Time(5.0));
  EXPECT_TRUE(released[1].answered);
}

TEST_F(Waiting, NeverHoldsScansWithoutEnd) {
  std::size_t num_released = 0;
  for (int i = 0; i < 1000; ++i) {
    scans.add(scanAt(5.0 + i), kNow);
    num_released += scans.release(kNow).size();
  }

  EXPECT_GE(num_released, 900U);
}

}  // namespace
}  // namespace map_matcher
