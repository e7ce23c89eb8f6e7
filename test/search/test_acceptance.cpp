#include <gtest/gtest.h>

#include "map_matcher/search/acceptance.hpp"

namespace map_matcher::search {
namespace {

/// A result that is accepted with the default options.
MatchResult convincing() {
  MatchResult result;
  result.T_reference_session = {1.5, 2.5, 0.5};
  result.total_cells = 1000;
  result.hit_cells = 800;
  result.hit_ratio = 0.8;
  result.certified = true;
  result.upper_bound = 0.8;
  result.runner_up_proven = true;
  result.margin = 0.1;
  return result;
}

std::string reasonOf(const MatchResult& result) { return judge(result, {}).reason; }

TEST(Acceptance, TakesWhatIsProvenHighEnoughAndFarEnoughAhead) {
  MatchResult with_runner_up = convincing();
  with_runner_up.runner_up = RunnerUp{{7.0, 8.0, 0.0}, 0.69};
  with_runner_up.margin = 0.11;

  EXPECT_EQ(judge(convincing(), {}).status, MatchStatus::kMatched);
  EXPECT_EQ(judge(with_runner_up, {}).status, MatchStatus::kMatched);
}

TEST(Acceptance, RefusesWhatIsNotProvenAndTellsTheGap) {
  MatchResult result = convincing();
  result.certified = false;
  result.upper_bound = 0.93;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kNotCertified);
  EXPECT_NE(reasonOf(result).find("no pose has a ratio above 0.93"), std::string::npos) << reasonOf(result);
}

TEST(Acceptance, RefusesAMarginThatIsNotProven) {
  MatchResult result = convincing();
  result.margin = 0.02;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kNotCertified);
  EXPECT_NE(reasonOf(result).find("the best of all"), std::string::npos) << reasonOf(result);
}

TEST(Acceptance, RefusesWhatAnotherPlaceEqualsAndNamesBothPlaces) {
  MatchResult result = convincing();
  result.runner_up = RunnerUp{{7.25, 8.5, -0.5}, 0.75};
  result.margin = 0.05;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kAmbiguous);
  EXPECT_NE(reasonOf(result).find("(1.5 m, 2.5 m, 0.5 rad)"), std::string::npos) << reasonOf(result);
  EXPECT_NE(reasonOf(result).find("(7.25 m, 8.5 m, -0.5 rad)"), std::string::npos) << reasonOf(result);
}

TEST(Acceptance, OneCompetitorIsEnoughEvenIfTheSearchForOthersWasCutShort) {
  MatchResult result = convincing();
  result.runner_up = RunnerUp{{7.25, 8.5, -0.5}, 0.79};
  result.runner_up_proven = false;
  result.margin = 0.0;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kAmbiguous);
  EXPECT_NE(reasonOf(result).find("a place elsewhere, (7.25 m"), std::string::npos) << reasonOf(result);
  EXPECT_EQ(reasonOf(result).find("the best place elsewhere"), std::string::npos) << reasonOf(result);
}

TEST(Acceptance, CallsNothingAmbiguousThatABetterPlaceMayStandOutFrom) {
  MatchResult result = convincing();
  result.certified = result.runner_up_proven = false;
  result.runner_up = RunnerUp{{7.25, 8.5, -0.5}, 0.79};
  result.margin = 0.0;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kNotCertified);
}

TEST(Acceptance, RefusesAMarginOfWhichTheRunnerUpIsNotProven) {
  MatchResult result = convincing();
  result.runner_up_proven = false;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kNotCertified);
  EXPECT_EQ(judge(result, {}, Standing::kContradicts).status, MatchStatus::kNotCertified);
}

TEST(Acceptance, NeedsNoMarginToFollowAnEarlierPlace) {
  MatchResult unproven = convincing();
  unproven.runner_up_proven = false;
  unproven.margin = 0.0;
  MatchResult rivalled = convincing();
  rivalled.runner_up = RunnerUp{{7.25, 8.5, -0.5}, 0.79};
  rivalled.margin = 0.01;
  MatchResult uncertified = convincing();
  uncertified.certified = uncertified.runner_up_proven = false;
  uncertified.margin = 0.0;

  EXPECT_EQ(judge(unproven, {}, Standing::kAgrees).status, MatchStatus::kMatched);
  EXPECT_EQ(judge(rivalled, {}, Standing::kAgrees).status, MatchStatus::kMatched);
  EXPECT_EQ(judge(uncertified, {}, Standing::kAgrees).status, MatchStatus::kNotCertified);
}

TEST(Acceptance, RefusesAShareOfHitsBelowTheLargerOfItsTwoLimits) {
  MatchResult result = convincing();
  result.hit_cells = 599;
  result.hit_ratio = 0.599;
  MatchOptions lower;
  lower.min_hit_ratio = 0.0;
  MatchOptions higher = lower;
  higher.coarse.acceptance_ratio = 0.7;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_EQ(judge(result, lower).status, MatchStatus::kMatched);
  EXPECT_EQ(judge(result, higher).status, MatchStatus::kBelowAcceptanceRatio);
}

TEST(Acceptance, BelievesAPlaceOtherThanAnEarlierOneOnlyWhenItIsConfirmed) {
  MatchOptions at_once;
  at_once.confirm_relocation = false;

  EXPECT_EQ(judge(convincing(), {}, Standing::kAgrees).status, MatchStatus::kMatched);
  EXPECT_EQ(judge(convincing(), {}, Standing::kConfirms).status, MatchStatus::kMatched);
  EXPECT_EQ(judge(convincing(), {}, Standing::kContradicts).status, MatchStatus::kUnconfirmed);
  EXPECT_EQ(judge(convincing(), at_once, Standing::kContradicts).status, MatchStatus::kMatched);
}

TEST(Acceptance, ProofThatNothingFitsIsNoMatch) {
  MatchResult result;
  result.total_cells = 1000;
  result.certified = true;

  EXPECT_EQ(judge(result, {}).status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_NE(reasonOf(result).find("0.6 of the 1000"), std::string::npos) << reasonOf(result);
}

}  // namespace
}  // namespace map_matcher::search
