#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "map_matcher/ros/matching/match_services.hpp"

namespace map_matcher::ros_matching {
namespace {

TEST(MatchToReferenceRequest, LeftAtZeroUsesTheNodesOptionsAndNoPrior) {
  belief::MatchOptions node;
  node.search.coarse = {3.0, 0.4};
  node.search.hits_sample_threshold = 500;

  const belief::MatchOptions options = optionsOf({}, node);

  EXPECT_EQ(options.search.coarse.rotation_downsampling, 3.0);
  EXPECT_EQ(options.search.coarse.acceptance_ratio, 0.4);
  EXPECT_EQ(options.search.hits_sample_threshold, 500);
  EXPECT_FALSE(constraintsOf({}).heading);
  EXPECT_FALSE(constraintsOf({}).window);
}

TEST(MatchToReferenceRequest, LooksAtAllSessionCellsWhenAskedForMinusOne) {
  belief::MatchOptions node;
  node.search.hits_sample_threshold = 500;
  MatchToReference::Request request;
  request.hits_sample_threshold = -1;

  EXPECT_EQ(optionsOf(request, node).search.hits_sample_threshold, 0);
}

TEST(MatchToReferenceRequest, TurnsAnUnlimitedHeadingPriorIntoAnOrder) {
  MatchToReference::Request request;
  request.use_heading_prior = true;
  request.heading = 1.5;

  const search::Constraints prior = constraintsOf(request);

  ASSERT_TRUE(prior.heading);
  EXPECT_EQ(prior.heading->yaw, 1.5);
  EXPECT_GE(prior.heading->half_width, M_PI);
}

TEST(MatchToReferenceRequest, RefusesAWindowOfNegativeSize) {
  MatchToReference::Request request;
  request.use_window_prior = true;
  request.window_half_size_y = -0.5;

  try {
    constraintsOf(request);
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "window_half_size_y is -0.5, expected at least 0 m");
  }
}

}  // namespace
}  // namespace map_matcher::ros_matching
