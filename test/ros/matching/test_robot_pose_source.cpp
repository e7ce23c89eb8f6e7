#include <gtest/gtest.h>
#include <tf2/LinearMath/Quaternion.h>
#include <tf2/buffer_core.h>

#include <string>
#include <vector>

#include "map_matcher/ros/matching/robot_pose_source.hpp"

namespace map_matcher::ros_matching {
namespace {

/// A tf buffer to fill: session_map -> odom -> base_link.
class RobotPoseSourceTest : public testing::Test {
 protected:
  void send(const std::string& parent, const std::string& child, double time, double x, double roll = 0.0,
            double pitch = 0.0, double yaw = 0.0) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(time);
    transform.child_frame_id = child;
    transform.transform.translation.x = x;
    tf2::Quaternion q;
    q.setRPY(roll, pitch, yaw);
    transform.transform.rotation.x = q.x();
    transform.transform.rotation.y = q.y();
    transform.transform.rotation.z = q.z();
    transform.transform.rotation.w = q.w();
    ASSERT_TRUE(tf_.setTransform(transform, "test"));
  }

  tf2::BufferCore tf_;
  RobotPoseSource source_{tf_, "base_link"};
};

TEST_F(RobotPoseSourceTest, TellsThePoseAtTheStampAndNotTheNewest) {
  send("session_map", "odom", 10.0, 1.0);
  send("session_map", "odom", 14.0, 1.0);
  send("odom", "base_link", 10.0, 0.0);
  send("odom", "base_link", 12.0, 2.0);
  send("odom", "base_link", 14.0, 20.0);

  for (const RobotPose& pose : {source_.at("session_map", ros::Time(11.0)), source_.at("/session_map", ros::Time(11.0)),
                                source_.atOrShortlyBefore("session_map", ros::Time(11.0))}) {
    ASSERT_TRUE(pose.T_session_base) << pose.reason;
    EXPECT_NEAR(pose.T_session_base->x, 2.0, 1e-9);
    EXPECT_EQ(pose.stamp, ros::Time(11.0));
    EXPECT_EQ(pose.reason, "");
  }
}

TEST_F(RobotPoseSourceTest, ProjectsATiltedRobotToThePlane) {
  send("session_map", "base_link", 10.0, 3.0, 0.1, -0.2, 0.7);

  const RobotPose pose = source_.at("session_map", ros::Time(10.0));

  ASSERT_TRUE(pose.T_session_base) << pose.reason;
  EXPECT_NEAR(pose.T_session_base->x, 3.0, 1e-9);
  EXPECT_NEAR(pose.T_session_base->yaw, 0.7, 1e-9);
}

TEST_F(RobotPoseSourceTest, TakesTheNewestPoseShortlyBeforeTheStampWhenAsked) {
  send("session_map", "base_link", 10.0, 3.0);
  const ros::Time shortly_after(10.0 + RobotPoseSource::kMaxAge);

  const RobotPose pose = source_.atOrShortlyBefore("session_map", shortly_after);

  ASSERT_TRUE(pose.T_session_base) << pose.reason;
  EXPECT_EQ(pose.stamp, ros::Time(10.0));
  EXPECT_FALSE(source_.at("session_map", shortly_after).T_session_base);
}

TEST_F(RobotPoseSourceTest, NeverTakesAPoseThatIsOlderOrNewer) {
  send("session_map", "base_link", 10.0, 3.0);
  send("session_map", "base_link", 10.1, 3.0);

  const RobotPose too_old = source_.atOrShortlyBefore("session_map", ros::Time(11.6));
  const RobotPose too_new = source_.atOrShortlyBefore("session_map", ros::Time(9.9));

  EXPECT_FALSE(too_old.T_session_base);
  EXPECT_EQ(too_old.reason,
            "tf knows where \"base_link\" is in \"session_map\" up to 1.5 s before the session map, expected at most "
            "0.5 s");
  EXPECT_FALSE(too_new.T_session_base);
  EXPECT_EQ(too_new.reason,
            "tf knows where \"base_link\" is in \"session_map\" up to 0.2 s after the session map, but not so long ago "
            "as that");
}

TEST_F(RobotPoseSourceTest, KnowsNoPoseForAMapWhoseStampLiesACenturyAway) {
  send("session_map", "base_link", 10.0, 3.0);

  const RobotPose pose = source_.atOrShortlyBefore("session_map", ros::Time(4'000'000'000U, 0));

  EXPECT_FALSE(pose.T_session_base);
  EXPECT_EQ(pose.reason,
            "tf knows where \"base_link\" is in \"session_map\" up to 4e+09 s before the session map, expected at most "
            "0.5 s");
}

TEST_F(RobotPoseSourceTest, SaysWhatTfDoesNotKnow) {
  EXPECT_EQ(source_.atOrShortlyBefore("session_map", ros::Time(10.0)).reason, "tf knows no frame \"base_link\"");

  send("odom", "base_link", 10.0, 0.0);
  EXPECT_EQ(source_.atOrShortlyBefore("session_map", ros::Time(10.0)).reason, "tf knows no frame \"session_map\"");

  send("map", "session_map", 10.0, 0.0);
  EXPECT_EQ(source_.atOrShortlyBefore("session_map", ros::Time(10.0)).reason,
            "tf connects \"base_link\" and \"session_map\" in no way");
}

TEST_F(RobotPoseSourceTest, KnowsNoPoseForAMapWithoutAStamp) {
  send("session_map", "base_link", 10.0, 3.0);

  const RobotPose pose = source_.atOrShortlyBefore("session_map", ros::Time());

  EXPECT_FALSE(pose.T_session_base);
  EXPECT_EQ(pose.reason, "the session map has no stamp");
}

TEST_F(RobotPoseSourceTest, NamesTheFramesFromTheRobotUpwards) {
  EXPECT_EQ(source_.framesUpwards(), std::vector<std::string>{"base_link"});

  send("odom", "base_link", 10.0, 0.0);
  send("session_map", "odom", 10.0, 0.0);

  EXPECT_EQ(source_.framesUpwards(), (std::vector<std::string>{"base_link", "odom", "session_map"}));
}

TEST_F(RobotPoseSourceTest, EndsWhereFramesAreAboveEachOther) {
  send("odom", "base_link", 10.0, 0.0);
  send("base_link", "odom", 10.0, 0.0);

  EXPECT_GE(source_.framesUpwards().size(), 2U);
}

}  // namespace
}  // namespace map_matcher::ros_matching
