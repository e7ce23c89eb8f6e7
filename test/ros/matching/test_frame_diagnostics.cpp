#include <gtest/gtest.h>

#include "map_matcher/ros/matching/frame_diagnostics.hpp"

namespace map_matcher::ros_matching {
namespace {

TEST(ContestedFrameText, NamesTheFrameItsParentsAndWhoSaysSo) {
  const std::string text = textOf({"odom", {{"map", "/amcl"}, {"session_map", "/slam_gmapping"}}});

  EXPECT_EQ(
      text.rfind("the frame \"odom\" has two parents on tf: \"map\" by /amcl, \"session_map\" by /slam_gmapping;", 0),
      0U)
      << text;
}

}  // namespace
}  // namespace map_matcher::ros_matching
