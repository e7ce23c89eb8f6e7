#include <gtest/gtest.h>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/detection_messages.hpp"

namespace map_matcher::ros_common {
namespace {

TEST(DetectionMessages, OfDrSpaamGivePositionsWhateverTheirQuaternions) {
  geometry_msgs::PoseArray message;
  message.header.frame_id = "/laser";
  message.header.stamp = ros::Time(12, 345678901);
  message.poses.resize(2);  // all quaternions zero
  message.poses[1].position.x = 1.5;
  message.poses[1].position.y = -0.5;

  const scrubbing::DetectionSet set = fromMessage(message, "dr_spaam");

  EXPECT_EQ(set.source, "dr_spaam");
  EXPECT_EQ(set.frame, "laser");
  EXPECT_EQ(set.stamp.count(), 12345678901);
  ASSERT_EQ(set.detections.size(), 2U);
  EXPECT_EQ(set.detections[1].position, Eigen::Vector3d(1.5, -0.5, 0.0));
  EXPECT_EQ(set.detections[1].score, 1.0);
}

TEST(DetectionMessages, WithScoresKeepThem) {
  PersonDetections message;
  message.header.frame_id = "laser";
  message.detections.resize(1);
  message.detections[0].position.x = 2.0;
  message.detections[0].score = 0.25F;

  const scrubbing::DetectionSet set = fromMessage(message, "detector");

  ASSERT_EQ(set.detections.size(), 1U);
  EXPECT_EQ(set.detections[0].position.x(), 2.0);
  EXPECT_EQ(set.detections[0].score, 0.25);
}

TEST(DetectionMessages, NeedAFrame) {
  EXPECT_THROW(fromMessage(geometry_msgs::PoseArray(), "detector"), MessageError);
  EXPECT_THROW(fromMessage(PersonDetections(), "detector"), MessageError);
}

}  // namespace
}  // namespace map_matcher::ros_common
