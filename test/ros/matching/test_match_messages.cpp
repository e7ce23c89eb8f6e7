#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "map_matcher/ros/matching/match_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

search::StageReport stage(const std::string& name, bool answered, double resolution, double rotation_step) {
  search::StageReport report;
  report.name = name;
  report.answered = answered;
  report.resolution = resolution;
  report.rotation_step = rotation_step;
  report.rotations = 7;
  report.matched_cells = 8;
  report.total_cells = 10;
  report.ratio = 0.8;
  report.nodes_scored = 5'000'000'000;
  report.nodes_expanded = 11;
  report.initialization_time = 0.1;
  report.rotation_expansion_time = 0.2;
  report.depth_first_search_time = 0.3;
  return report;
}

belief::Answer matchedResult() {
  belief::Answer result;
  result.status = belief::MatchStatus::kMatched;
  result.reason = "80 of 100 cells";
  result.search.T_reference_session = {1.0, -2.0, M_PI / 2.0};
  result.search.covariance << 1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 3.0;
  result.search.refined = true;
  result.search.matched_cells = 80;
  result.search.total_cells = 100;
  result.search.ratio = 0.8;
  result.search.certified = true;
  result.search.replaced = true;
  result.search.hit_cells = 90;
  result.search.hit_ratio = 0.9;
  result.search.upper_bound = 0.95;
  result.search.runner_up = search::RunnerUp{{3.0, 4.0, 0.5}, 0.7};
  result.search.margin = 0.2;
  result.nearby = {200, 10.0, 0.75, 90, 4.5, 0.5};
  result.evidence = {{"margin", 0.2, 0.1, belief::Bearing::kFor, belief::MatchStatus::kAmbiguous, "far ahead"},
                     {"proof", 0.05, 0.0, belief::Bearing::kAgainst, belief::MatchStatus::kNotCertified, "not proven"}};
  result.search.stages = {stage("coarse", true, 0.2, 0.02), stage("fine", true, 0.05, 0.004)};
  result.search.search_time = 0.6;
  result.search.reference_time = 0.7;
  return result;
}

TEST(MatchMessages, CarryEverythingOfAResult) {
  const MapMatch message = toMessage(matchedResult());

  EXPECT_EQ(message.status, MapMatch::MATCHED);
  EXPECT_EQ(message.status_text, "matched");
  EXPECT_EQ(message.reason, "80 of 100 cells");
  ASSERT_EQ(message.evidence.size(), 2U);
  EXPECT_EQ(message.evidence[0].name, "margin");
  EXPECT_EQ(message.evidence[0].value, 0.2);
  EXPECT_EQ(message.evidence[0].limit, 0.1);
  EXPECT_EQ(message.evidence[0].bearing, Evidence::FOR);
  EXPECT_EQ(message.evidence[0].text, "far ahead");
  EXPECT_EQ(message.evidence[1].bearing, Evidence::AGAINST);
  EXPECT_EQ(message.x, 1.0);
  EXPECT_EQ(message.y, -2.0);
  EXPECT_EQ(message.yaw, M_PI / 2.0);
  EXPECT_EQ(message.T_reference_session.translation.x, 1.0);
  EXPECT_NEAR(message.T_reference_session.rotation.z, std::sqrt(0.5), 1e-12);
  EXPECT_EQ(message.covariance[1], 0.1);
  EXPECT_EQ(message.covariance[5], 0.3);
  EXPECT_EQ(message.covariance[8], 3.0);
  EXPECT_TRUE(message.refined);
  EXPECT_EQ(message.matched_cells, 80);
  EXPECT_EQ(message.total_cells, 100);
  EXPECT_EQ(message.ratio, 0.8);
  EXPECT_TRUE(message.certified);
  EXPECT_TRUE(message.replaced);
  EXPECT_EQ(message.hit_cells, 90);
  EXPECT_EQ(message.hit_ratio, 0.9);
  EXPECT_EQ(message.upper_bound, 0.95);
  EXPECT_TRUE(message.has_runner_up);
  EXPECT_EQ(message.runner_up_x, 3.0);
  EXPECT_EQ(message.runner_up_y, 4.0);
  EXPECT_EQ(message.runner_up_yaw, 0.5);
  EXPECT_EQ(message.runner_up_ratio, 0.7);
  EXPECT_EQ(message.margin, 0.2);
  EXPECT_EQ(message.nearby_cells, 200);
  EXPECT_EQ(message.nearby_ratio, 0.75);
  EXPECT_EQ(message.nearby_walls, 90);
  EXPECT_EQ(message.nearby_walls_ratio, 0.5);
  EXPECT_EQ(message.search_time, 0.6);
  EXPECT_EQ(message.reference_time, 0.7);
  ASSERT_EQ(message.stages.size(), 2U);
  const MatchStage& fine = message.stages[1];
  EXPECT_EQ(fine.name, "fine");
  EXPECT_TRUE(fine.answered);
  EXPECT_EQ(fine.resolution, 0.05);
  EXPECT_EQ(fine.rotations, 7);
  EXPECT_EQ(fine.rotation_step, 0.004);
  EXPECT_EQ(fine.matched_cells, 8);
  EXPECT_EQ(fine.total_cells, 10);
  EXPECT_EQ(fine.ratio, 0.8);
  EXPECT_EQ(fine.nodes_scored, 5'000'000'000);
  EXPECT_EQ(fine.nodes_expanded, 11);
  EXPECT_EQ(fine.initialization_time, 0.1);
  EXPECT_EQ(fine.rotation_expansion_time, 0.2);
  EXPECT_EQ(fine.depth_first_search_time, 0.3);
}

TEST(MatchMessages, HaveNoPoseWhenNothingMatched) {
  belief::Answer result = matchedResult();
  result.status = belief::MatchStatus::kBelowAcceptanceRatio;

  const MapMatch message = toMessage(result);

  EXPECT_EQ(message.status, MapMatch::BELOW_ACCEPTANCE_RATIO);
  EXPECT_EQ(message.status_text, "below_acceptance_ratio");
  EXPECT_TRUE(std::isnan(message.x));
  EXPECT_TRUE(std::isnan(message.T_reference_session.translation.x));
  EXPECT_TRUE(std::isnan(message.T_reference_session.rotation.w));
  EXPECT_TRUE(std::isnan(message.covariance[0]));
}

TEST(MatchMessages, NameEachStatusAsTheSearchDoes) {
  const std::vector<std::pair<belief::MatchStatus, std::uint8_t>> statuses{
      {belief::MatchStatus::kMatched, MapMatch::MATCHED},
      {belief::MatchStatus::kBelowAcceptanceRatio, MapMatch::BELOW_ACCEPTANCE_RATIO},
      {belief::MatchStatus::kNoReference, MapMatch::NO_REFERENCE},
      {belief::MatchStatus::kEmptyReference, MapMatch::EMPTY_REFERENCE},
      {belief::MatchStatus::kTooFewSessionCells, MapMatch::TOO_FEW_SESSION_CELLS},
      {belief::MatchStatus::kSessionTooLarge, MapMatch::SESSION_TOO_LARGE},
      {belief::MatchStatus::kStopped, MapMatch::STOPPED},
      {belief::MatchStatus::kNotCertified, MapMatch::NOT_CERTIFIED},
      {belief::MatchStatus::kAmbiguous, MapMatch::AMBIGUOUS},
      {belief::MatchStatus::kDoubtful, MapMatch::DOUBTFUL},
      {belief::MatchStatus::kUnconfirmed, MapMatch::UNCONFIRMED},
      {belief::MatchStatus::kRobotLost, MapMatch::ROBOT_LOST},
  };
  for (const auto& [status, constant] : statuses) {
    belief::Answer result;
    result.status = status;
    EXPECT_EQ(toMessage(result).status, constant);
    EXPECT_EQ(toMessage(result).status_text, toString(status));
  }
}

TEST(MatchMessages, PlaceTheRobotWithTheUncertaintyOfTheMatch) {
  belief::Answer result = matchedResult();
  result.search.covariance = Eigen::Vector3d(0.01, 0.02, 0.001).asDiagonal();

  const auto pose = robotPose(toMessage(result), {3.0, 0.5, -M_PI / 2.0});

  EXPECT_NEAR(pose.pose.position.x, 0.5, 1e-12);
  EXPECT_NEAR(pose.pose.position.y, 1.0, 1e-12);
  EXPECT_NEAR(pose.pose.orientation.w, 1.0, 1e-12);
  // The robot is (-0.5, 3) m from the origin of the session map, along the axes of the reference map.
  EXPECT_NEAR(pose.covariance[0], 0.01 + 9.0 * 0.001, 1e-12);
  EXPECT_NEAR(pose.covariance[7], 0.02 + 0.25 * 0.001, 1e-12);
  EXPECT_NEAR(pose.covariance[1], 1.5 * 0.001, 1e-12);
  EXPECT_NEAR(pose.covariance[5], -3.0 * 0.001, 1e-12);
  EXPECT_NEAR(pose.covariance[35], 0.001, 1e-12);
}

}  // namespace
}  // namespace map_matcher::ros_matching
