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

  EXPECT_TRUE(parents.parentOf("session_map", ros::Time(10.0 + FrameParents::kLeastMemory)));
  EXPECT_FALSE(parents.parentOf("session_map", ros::Time(10.1 + FrameParents::kLeastMemory)));
}

TEST(FrameParents, RemembersAParentThatComesSeldomFromOneTimeToTheNext) {
  FrameParents parents;
  for (double time = 10.0; time <= 40.0; time += 3.0) {
    parents.add(transform("odom", "session_map"), "/mapper", false, ros::Time(time));

    EXPECT_TRUE(parents.parentOf("session_map", ros::Time(time + 2.9)));
  }
}

TEST(FrameParents, RemembersAParentForThreeOfItsLongestIntervals) {
  FrameParents parents;
  for (const double time : {10.0, 11.0, 17.0, 18.0}) {
    parents.add(transform("odom", "session_map"), "/mapper", false, ros::Time(time));
  }

  EXPECT_TRUE(parents.parentOf("session_map", ros::Time(18.0 + 3.0 * 6.0)));
  EXPECT_FALSE(parents.parentOf("session_map", ros::Time(18.1 + 3.0 * 6.0)));
}

TEST(FrameParents, NeverRemembersAParentOnTfForMoreThanAMinute) {
  FrameParents parents;
  for (const double time : {10.0, 40.0, 1000.0, 1000.1}) {  // it was away after the second
    parents.add(transform("odom", "session_map"), "/mapper", false, ros::Time(time));
  }
  EXPECT_FALSE(parents.parentOf("session_map", ros::Time(1000.2 + FrameParents::kLeastMemory)));

  parents.add(transform("odom", "session_map"), "/mapper", false, ros::Time(1040.0));

  EXPECT_TRUE(parents.parentOf("session_map", ros::Time(1040.0 + FrameParents::kMostMemory)));
  EXPECT_FALSE(parents.parentOf("session_map", ros::Time(1040.1 + FrameParents::kMostMemory)));
}

TEST(FrameParents, NamesTheNewestOfSeveralParents) {
  FrameParents parents;
  parents.add(transform("map", "odom"), "/amcl", false, ros::Time(10.0));
  parents.add(transform("session_map", "odom"), "/mapper", false, ros::Time(10.1));
  EXPECT_EQ(parents.parentOf("odom", ros::Time(10.2))->publisher, "/mapper");

  parents.add(transform("map", "odom"), "/amcl", false, ros::Time(10.3));

  EXPECT_EQ(parents.parentOf("odom", ros::Time(10.4))->publisher, "/amcl");
}

TEST(FrameParents, TellsFramesThatTwoNodesGiveDifferentParents) {
  FrameParents parents;
  parents.add(transform("odom", "base_link"), "/robot", false, ros::Time(10.0));
  parents.add(transform("map", "odom"), "/amcl", false, ros::Time(10.0));
  parents.add(transform("session_map", "odom"), "/mapper", false, ros::Time(11.0));
  parents.add(transform("a", "elsewhere"), "/one", true, ros::Time(10.0));
  parents.add(transform("b", "elsewhere"), "/other", true, ros::Time(10.0));

  const auto contested = parents.contestedAmong({"base_link", "odom", "nowhere"}, ros::Time(12.0));

  ASSERT_EQ(contested.size(), 1U);
  EXPECT_EQ(contested[0].frame, "odom");
  ASSERT_EQ(contested[0].parents.size(), 2U);
  EXPECT_EQ(contested[0].parents[0].publisher, "/amcl");
  EXPECT_EQ(contested[0].parents[0].parent, "map");
  EXPECT_EQ(contested[0].parents[1].publisher, "/mapper");
  EXPECT_EQ(contested[0].parents[1].parent, "session_map");
}

TEST(FrameParents, TellsNoFrameThatTwoNodesAgreeAboutOrThatOneOfThemNoLongerSends) {
  FrameParents parents;
  parents.add(transform("odom", "base_link"), "/robot", false, ros::Time(10.0));
  parents.add(transform("/odom", "/base_link"), "/filter", false, ros::Time(10.0));
  parents.add(transform("map", "odom"), "/amcl", false, ros::Time(10.0));
  parents.add(transform("session_map", "odom"), "/mapper", false, ros::Time(15.0));

  EXPECT_TRUE(parents.contestedAmong({"base_link", "odom"}, ros::Time(20.1)).empty());
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
