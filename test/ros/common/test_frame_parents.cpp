#include <gtest/gtest.h>

#include "map_matcher/ros/common/frame_parents.hpp"

namespace map_matcher::ros_common {
namespace {

tf2_msgs::TFMessage transform(const std::string& parent, const std::string& child) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header.frame_id = parent;
  message.transforms[0].child_frame_id = child;
  return message;
}

TEST(FrameParents, KnowsNoParentOfAFrameThatNobodySends) {
  FrameParents parents;
  parents.add(transform("odom", "base_link"), "/robot", false, ros::Time(10.0));

  EXPECT_FALSE(parents.parentOf("session_map", ros::Time(10.0)));
}

TEST(FrameParents, NamesTheParentAndWhoSendsIt) {
  FrameParents parents;
  parents.add(transform("/odom", "/session_map"), "/mapper", false, ros::Time(10.0));

  const auto parent = parents.parentOf("session_map", ros::Time(10.1));

  ASSERT_TRUE(parent);
  EXPECT_EQ(parent->parent, "odom");
  EXPECT_EQ(parent->publisher, "/mapper");
}

TEST(FrameParents, ForgetsAParentThatIsNoLongerSent) {
  FrameParents parents;
  parents.add(transform("odom", "session_map"), "/mapper", false, ros::Time(10.0));

  EXPECT_TRUE(parents.parentOf("session_map", ros::Time(10.0 + FrameParents::kTimeout)));
  EXPECT_FALSE(parents.parentOf("session_map", ros::Time(10.1 + FrameParents::kTimeout)));
}

TEST(FrameParents, ForgetsAParentWhenTimeGoesBack) {
  FrameParents parents;
  parents.add(transform("odom", "session_map"), "/mapper", false, ros::Time(100.0));

  EXPECT_FALSE(parents.parentOf("session_map", ros::Time(10.0)));
}

TEST(FrameParents, NeverForgetsAStaticParent) {
  FrameParents parents;
  parents.add(transform("odom", "session_map"), "/launch", true, ros::Time(10.0));
  parents.add(transform("map", "session_map"), "/mapper", false, ros::Time(20.0));

  const auto parent = parents.parentOf("session_map", ros::Time(1000.0));

  ASSERT_TRUE(parent);
  EXPECT_EQ(parent->parent, "odom");
}

}  // namespace
}  // namespace map_matcher::ros_common
