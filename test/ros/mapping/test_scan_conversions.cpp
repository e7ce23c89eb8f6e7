#include <gtest/gtest.h>
#include <tf2/LinearMath/Quaternion.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <limits>

#include "map_matcher/mapping/beams.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"

namespace map_matcher::ros_common {
namespace {

geometry_msgs::Transform transformOf(double x, double y, double roll, double pitch, double yaw) {
  tf2::Quaternion quaternion;
  quaternion.setRPY(roll, pitch, yaw);
  geometry_msgs::Transform transform;
  transform.translation.x = x;
  transform.translation.y = y;
  transform.translation.z = 0.3;
  transform.rotation.x = quaternion.x();
  transform.rotation.y = quaternion.y();
  transform.rotation.z = quaternion.z();
  transform.rotation.w = quaternion.w();
  return transform;
}

sensor_msgs::LaserScan scanMessage() {
  sensor_msgs::LaserScan message;
  message.angle_min = -1.0F;
  message.angle_max = 0.0F;
  message.angle_increment = 0.5F;
  message.range_max = 10.0F;
  message.ranges = {1.0F, 2.0F, 3.0F};
  return message;
}

TEST(ScanConversions, TakeTheRangesAsTheyAre) {
  const scan::PlanarScan scan = ros_common::fromMessage(scanMessage());

  EXPECT_DOUBLE_EQ(scan.angle_min, -1.0);
  EXPECT_DOUBLE_EQ(scan.angle_increment, 0.5);
  EXPECT_EQ(scan.ranges, (std::vector<float>{1.0F, 2.0F, 3.0F}));
}

TEST(ScanConversions, CheckThatAnglesAndRangesAgree) {
  sensor_msgs::LaserScan message = scanMessage();
  EXPECT_NO_THROW(checkLayout(message));
  message.angle_max = 0.9F;  // two beams short: drivers count so
  EXPECT_NO_THROW(checkLayout(message));

  message.angle_max = 1.5F;
  EXPECT_THROW(checkLayout(message), ros_common::MessageError);
  message = scanMessage();
  message.ranges.clear();
  EXPECT_THROW(checkLayout(message), ros_common::MessageError);
  message = scanMessage();
  message.angle_min = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(checkLayout(message), ros_common::MessageError);
}

sensor_msgs::LaserScanConstPtr sharedScan() {
  const auto message = boost::make_shared<sensor_msgs::LaserScan>(scanMessage());
  message->header.frame_id = "/laser";
  message->header.stamp = ros::Time(10, 5);
  message->header.seq = 7;
  message->intensities = {0.5F, 0.5F, 0.5F};
  return message;
}

TEST(ScanConversions, HandTheRangesOfAMessageToTheScrubberWithoutACopy) {
  scrubbing::RawScan raw;
  const float* ranges = nullptr;
  {
    const auto message = sharedScan();
    raw = rawScanOf(message);
    ranges = message->ranges.data();
  }

  EXPECT_EQ(raw.frame, "laser");
  EXPECT_EQ(raw.stamp, std::chrono::seconds(10) + scrubbing::Stamp(5));
  EXPECT_EQ(raw.ranges->data(), ranges);
  EXPECT_EQ((*raw.ranges)[2], 3.0F);
}

TEST(ScanConversions, HandOnTheVeryMessageOfAScanFromWhichNothingIsRemoved) {
  const auto message = sharedScan();

  EXPECT_EQ(scrubbedMessage(message, {message->ranges, {}, 0, 3}), message);
}

TEST(ScanConversions, ChangeNothingButTheRangesOfAScrubbedScan) {
  const auto message = sharedScan();

  const auto scrubbed = scrubbedMessage(message, {{1.0F, 9.0F, 3.0F}, {1}, 1, 3});

  EXPECT_EQ(message->ranges, scanMessage().ranges);  // not mutated
  EXPECT_EQ(scrubbed->ranges, (std::vector<float>{1.0F, 9.0F, 3.0F}));
  sensor_msgs::LaserScan restored = *scrubbed;
  restored.ranges = message->ranges;
  EXPECT_EQ(restored, *message);
}

TEST(ScanConversions, RefuseAScanWhoseIncrementIsAbsurdThoughItsAnglesAgree) {
  auto message = boost::make_shared<sensor_msgs::LaserScan>(*sharedScan());
  message->angle_increment = 1e8F;
  message->angle_max = message->angle_min + 2e8F;

  EXPECT_THROW(rawScanOf(message), ros_common::MessageError);
}

TEST(ScanConversions, RefuseAScanThatIsNotValid) {
  sensor_msgs::LaserScan message = scanMessage();
  message.angle_increment = 0.0F;

  EXPECT_THROW(ros_common::fromMessage(message), ros_common::MessageError);
}

TEST(ScanConversions, TellAnUprightLaserFromOneUpsideDown) {
  const scan::LaserMount upright = laserMountFrom(transformOf(0.2, -0.1, 0.0, 0.0, 0.5));
  const scan::LaserMount inverted = laserMountFrom(transformOf(0.2, -0.1, M_PI, 0.0, 0.5));

  EXPECT_FALSE(upright.upside_down);
  EXPECT_TRUE(inverted.upside_down);
  for (const scan::LaserMount& mount : {upright, inverted}) {
    EXPECT_NEAR(mount.T_base_laser.x, 0.2, 1e-12);
    EXPECT_NEAR(mount.T_base_laser.y, -0.1, 1e-12);
    EXPECT_NEAR(mount.T_base_laser.yaw, 0.5, 1e-9);
  }
}

TEST(ScanConversions, PutTheBeamsOfALaserUpsideDownWhereTheTransformPutsThem) {
  // Turned by pi about its x axis, then by 0.5 about the vertical: a beam at +a points to 0.5 - a.
  const scan::LaserMount mount = laserMountFrom(transformOf(0.0, 0.0, M_PI, 0.0, 0.5));

  const mapping::BeamFan fan = mapping::castBeams({0.2, 0.1, 0.0, 10.0, {1.0F}}, mount, {});

  EXPECT_NEAR(std::atan2(fan.beams[0].end.y(), fan.beams[0].end.x()), 0.3, 1e-9);
}

TEST(ScanConversions, RefuseALaserThatIsTilted) {
  EXPECT_NO_THROW(laserMountFrom(transformOf(0.0, 0.0, 0.02, 0.0, 0.0)));
  EXPECT_THROW(laserMountFrom(transformOf(0.0, 0.0, 0.1, 0.0, 0.0)), ros_common::MessageError);
  EXPECT_THROW(laserMountFrom(transformOf(0.0, 0.0, 0.0, M_PI_2, 0.0)), ros_common::MessageError);
}

TEST(ScanConversions, ProjectOdometryToThePlane) {
  const grid::Rigid2 pose = projectToPlane(transformOf(1.0, 2.0, 0.05, -0.03, 2.5), "the odometry");

  EXPECT_DOUBLE_EQ(pose.x, 1.0);
  EXPECT_DOUBLE_EQ(pose.y, 2.0);
  EXPECT_NEAR(pose.yaw, 2.5, 1e-9);
}

TEST(ScanConversions, RefuseTransformsThatAreNotFiniteOrNotNormalised) {
  geometry_msgs::Transform not_finite = transformOf(1.0, 2.0, 0.0, 0.0, 0.0);
  not_finite.translation.y = std::numeric_limits<double>::infinity();
  geometry_msgs::Transform not_normalised = transformOf(1.0, 2.0, 0.0, 0.0, 0.0);
  not_normalised.rotation.w = 0.0;

  EXPECT_THROW(projectToPlane(not_finite, "the odometry"), ros_common::MessageError);
  EXPECT_THROW(projectToPlane(not_normalised, "the odometry"), ros_common::MessageError);
  EXPECT_THROW(laserMountFrom(not_finite), ros_common::MessageError);
}

TEST(ScanConversions, RefuseTransformsToWhereNoRobotIs) {
  const double far = 1.01e8;

  EXPECT_THROW(projectToPlane(transformOf(far, 0.0, 0.0, 0.0, 0.0), "the odometry"), ros_common::MessageError);
  EXPECT_THROW(projectToPlane(transformOf(0.0, -far, 0.0, 0.0, 0.0), "the odometry"), ros_common::MessageError);
  EXPECT_THROW(laserMountFrom(transformOf(1e300, 0.0, 0.0, 0.0, 0.0)), ros_common::MessageError);
  EXPECT_NO_THROW(projectToPlane(transformOf(5e5, 5.5e6, 0.0, 0.0, 0.0), "UTM"));
}

}  // namespace
}  // namespace map_matcher::ros_common
