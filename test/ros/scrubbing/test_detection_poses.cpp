#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/ros/common/tf_transforms.hpp"

namespace map_matcher::ros_scrubbing {
namespace {

using std::chrono::milliseconds;

geometry_msgs::TransformStamped stampedTransform(const std::string& parent, const std::string& child,
                                                 scrubbing::Stamp stamp, double x, double yaw) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.header.stamp.fromNSec(static_cast<std::uint64_t>(stamp.count()));
  message.child_frame_id = child;
  message.transform.translation.x = x;
  message.transform.rotation.z = std::sin(0.5 * yaw);
  message.transform.rotation.w = std::cos(0.5 * yaw);
  return message;
}

/// A robot that drives along x at 1 m/s, with a laser 0.2 m ahead of its base and one behind that looks back.
class Poses : public testing::Test {
 protected:
  Poses() {
    tf.setTransform(stampedTransform("base", "laser", scrubbing::Stamp(0), 0.2, 0.0), "test", true);
    tf.setTransform(stampedTransform("base", "rear_laser", scrubbing::Stamp(0), -0.2, M_PI), "test", true);
  }

  void drive(scrubbing::Stamp from, scrubbing::Stamp to) {
    for (scrubbing::Stamp stamp = from; stamp <= to; stamp += milliseconds(50)) {
      tf.setTransform(stampedTransform("odom", "base", stamp, scrubbing::seconds(stamp), 0.0), "test");
    }
  }

  const std::string laser = "laser";
  const std::string rear_laser = "rear_laser";
  tf2::BufferCore tf;
  ros_common::TfTransforms transforms{tf};
  scrubbing::DetectionPoses poses{transforms, "odom"};
};

TEST_F(Poses, TakeOutTheMotionOfTheRobot) {
  drive(milliseconds(1000), milliseconds(2000));

  const scrubbing::DetectionPose pose = poses.lookUp({laser, milliseconds(1200)}, {laser, milliseconds(1400)});

  EXPECT_EQ(pose.path, scrubbing::PosePath::kFixedFrame);
  ASSERT_TRUE(pose.T_scan_set);
  EXPECT_NEAR(pose.T_scan_set->translation().x(), -0.2, 1e-9);
}

TEST_F(Poses, LeadFromOneLaserToTheOther) {
  drive(milliseconds(1000), milliseconds(2000));

  const scrubbing::DetectionPose pose = poses.lookUp({rear_laser, milliseconds(1400)}, {laser, milliseconds(1400)});

  ASSERT_TRUE(pose.T_scan_set);
  const Eigen::Vector3d person = *pose.T_scan_set * Eigen::Vector3d(1.0, 0.0, 0.0);  // 1 m behind the rear laser
  EXPECT_NEAR(person.x(), -1.4, 1e-9);
  EXPECT_NEAR(person.y(), 0.0, 1e-9);
}

TEST_F(Poses, UseTheNewestTransformForAScanThatIsALittleNewer) {
  drive(milliseconds(1000), milliseconds(1400));

  const scrubbing::DetectionPose pose = poses.lookUp({laser, milliseconds(1200)}, {laser, milliseconds(1450)});

  EXPECT_EQ(pose.path, scrubbing::PosePath::kNewest);
  ASSERT_TRUE(pose.T_scan_set);
  EXPECT_NEAR(pose.T_scan_set->translation().x(), -0.2, 1e-9);
}

TEST_F(Poses, TakeTheRobotToStandStillWhenTfIsOld) {
  drive(milliseconds(1000), milliseconds(1400));

  const scrubbing::DetectionPose pose = poses.lookUp({laser, milliseconds(1900)}, {laser, milliseconds(2000)});

  EXPECT_EQ(pose.path, scrubbing::PosePath::kSensorFrame);
  ASSERT_TRUE(pose.T_scan_set);
  EXPECT_TRUE(pose.T_scan_set->isApprox(Eigen::Isometry3d::Identity()));
}

TEST_F(Poses, NeedNoTfAtAllInOneFrame) {
  tf.clear();

  const scrubbing::DetectionPose pose = poses.lookUp({laser, milliseconds(1200)}, {laser, milliseconds(1400)});

  EXPECT_EQ(pose.path, scrubbing::PosePath::kSensorFrame);
}

TEST_F(Poses, AreUnknownBetweenFramesThatTfDoesNotConnect) {
  const scrubbing::DetectionPose pose = poses.lookUp({"camera", milliseconds(1200)}, {laser, milliseconds(1400)});

  EXPECT_EQ(pose.path, scrubbing::PosePath::kNone);
  EXPECT_FALSE(pose.T_scan_set);
}

TEST_F(Poses, DoWithoutAFixedFrame) {
  drive(milliseconds(1000), milliseconds(2000));

  const scrubbing::DetectionPose pose =
      scrubbing::DetectionPoses(transforms, "").lookUp({rear_laser, milliseconds(1200)}, {laser, milliseconds(1400)});

  EXPECT_EQ(pose.path, scrubbing::PosePath::kSensorFrame);
  ASSERT_TRUE(pose.T_scan_set);
  EXPECT_NEAR(pose.T_scan_set->translation().x(), -0.4, 1e-9);
}

TEST_F(Poses, TakeTheRobotToStandStillAtStampsThatNoClockCanShow) {
  drive(milliseconds(1000), milliseconds(2000));
  const scrubbing::Stamp impossible = std::chrono::hours(24 * 365 * 200);

  const scrubbing::DetectionPose pose = poses.lookUp({laser, impossible}, {laser, impossible});

  EXPECT_EQ(pose.path, scrubbing::PosePath::kSensorFrame);
}

TEST_F(Poses, AtAnInstantAreNoOlderThanAsked) {
  drive(milliseconds(1000), milliseconds(2000));

  const auto now = scrubbing::poseAt(transforms, "odom", {laser, milliseconds(1700)}, scrubbing::kMaxTransformAge);
  ASSERT_TRUE(now);
  EXPECT_NEAR(now->translation().x(), 1.9, 1e-9);
  const auto a_little_later =
      scrubbing::poseAt(transforms, "odom", {laser, milliseconds(2200)}, scrubbing::kMaxTransformAge);
  ASSERT_TRUE(a_little_later);
  EXPECT_NEAR(a_little_later->translation().x(), 2.2, 1e-9);
  EXPECT_FALSE(scrubbing::poseAt(transforms, "odom", {laser, milliseconds(2201)}, scrubbing::kMaxTransformAge));
  EXPECT_FALSE(scrubbing::poseAt(transforms, "odom", {laser, milliseconds(900)}, scrubbing::kMaxTransformAge));
}

}  // namespace
}  // namespace map_matcher::ros_scrubbing
