#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "map_matcher/belief/agreement.hpp"
#include "map_matcher/belief/judge.hpp"

namespace map_matcher::belief {
namespace {

/// A result that is accepted with the default options.
search::SearchResult convincing() {
  search::SearchResult result;
  result.exact = result.found = true;
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

/// What is known when a place stands to those of earlier maps in some way.
Circumstances standing(Standing standing) {
  const grid::Rigid2 here = convincing().T_reference_session;
  const grid::Rigid2 elsewhere{here.x + 5.0, here.y, here.yaw};
  Circumstances circumstances;
  if (standing != Standing::kFirst) {
    circumstances.alignment = standing == Standing::kAgrees ? here : elsewhere;
  }
  if (standing == Standing::kConfirms) {
    circumstances.contender = here;
  }
  return circumstances;
}

std::string reasonOf(const search::SearchResult& result) { return judge({result}, {}).reason; }

TEST(Judge, TakesWhatIsProvenHighEnoughAndFarEnoughAhead) {
  search::SearchResult with_runner_up = convincing();
  with_runner_up.runner_up = search::RunnerUp{{7.0, 8.0, 0.0}, 0.69};
  with_runner_up.margin = 0.11;

  EXPECT_EQ(judge({convincing()}, {}).status, MatchStatus::kMatched);
  EXPECT_EQ(judge({with_runner_up}, {}).status, MatchStatus::kMatched);
}

TEST(Judge, RefusesWhatIsNotProvenAndTellsTheGap) {
  search::SearchResult result = convincing();
  result.certified = false;
  result.upper_bound = 0.93;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kNotCertified);
  EXPECT_NE(reasonOf(result).find("no pose has a ratio above 0.93"), std::string::npos) << reasonOf(result);
}

TEST(Judge, RefusesAMarginThatIsNotProven) {
  search::SearchResult result = convincing();
  result.ending = search::SearchEnding::kOutOfTime;
  result.margin = 0.02;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kNotCertified);
  EXPECT_NE(reasonOf(result).find("the best of all"), std::string::npos) << reasonOf(result);
}

TEST(Judge, RefusesWhatAnotherPlaceEqualsAndNamesBothPlaces) {
  search::SearchResult result = convincing();
  result.runner_up = search::RunnerUp{{7.25, 8.5, -0.5}, 0.75};
  result.margin = 0.05;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kAmbiguous);
  EXPECT_NE(reasonOf(result).find("(1.5 m, 2.5 m, 0.5 rad)"), std::string::npos) << reasonOf(result);
  EXPECT_NE(reasonOf(result).find("(7.25 m, 8.5 m, -0.5 rad)"), std::string::npos) << reasonOf(result);
}

TEST(Judge, OneCompetitorIsEnoughEvenIfTheSearchForOthersWasCutShort) {
  search::SearchResult result = convincing();
  result.runner_up = search::RunnerUp{{7.25, 8.5, -0.5}, 0.79};
  result.runner_up_proven = false;
  result.margin = 0.0;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kAmbiguous);
  EXPECT_NE(reasonOf(result).find("a place elsewhere, (7.25 m"), std::string::npos) << reasonOf(result);
  EXPECT_EQ(reasonOf(result).find("the best place elsewhere"), std::string::npos) << reasonOf(result);
}

TEST(Judge, CallsNothingAmbiguousThatABetterPlaceMayStandOutFrom) {
  search::SearchResult result = convincing();
  result.certified = result.runner_up_proven = false;
  result.runner_up = search::RunnerUp{{7.25, 8.5, -0.5}, 0.79};
  result.margin = 0.0;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kNotCertified);
}

TEST(Judge, RefusesAMarginOfWhichTheRunnerUpIsNotProven) {
  search::SearchResult result = convincing();
  result.runner_up_proven = false;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kNotCertified);
  EXPECT_EQ(judge({result}, {}, standing(Standing::kContradicts)).status, MatchStatus::kNotCertified);
}

TEST(Judge, NeedsNoMarginToFollowAnEarlierPlace) {
  search::SearchResult unproven = convincing();
  unproven.runner_up_proven = false;
  unproven.margin = 0.0;
  search::SearchResult rivalled = convincing();
  rivalled.runner_up = search::RunnerUp{{7.25, 8.5, -0.5}, 0.79};
  rivalled.margin = 0.01;
  search::SearchResult uncertified = convincing();
  uncertified.certified = uncertified.runner_up_proven = false;
  uncertified.margin = 0.0;

  EXPECT_EQ(judge({unproven}, {}, standing(Standing::kAgrees)).status, MatchStatus::kMatched);
  EXPECT_EQ(judge({rivalled}, {}, standing(Standing::kAgrees)).status, MatchStatus::kMatched);
  EXPECT_EQ(judge({uncertified}, {}, standing(Standing::kAgrees)).status, MatchStatus::kNotCertified);
}

TEST(Judge, RefusesAShareOfHitsBelowItsLimit) {
  search::SearchResult result = convincing();
  result.hit_cells = 299;
  result.hit_ratio = 0.299;
  MatchOptions lower;
  lower.belief.min_hit_ratio = 0.0;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_EQ(judge({result}, lower).status, MatchStatus::kMatched);
}

TEST(Judge, BelievesAPlaceOtherThanAnEarlierOneOnlyWhenItIsConfirmed) {
  MatchOptions at_once;
  at_once.belief.confirm_relocation = false;

  EXPECT_EQ(judge({convincing()}, {}, standing(Standing::kAgrees)).status, MatchStatus::kMatched);
  EXPECT_EQ(judge({convincing()}, {}, standing(Standing::kConfirms)).status, MatchStatus::kMatched);
  EXPECT_EQ(judge({convincing()}, {}, standing(Standing::kContradicts)).status, MatchStatus::kUnconfirmed);
  EXPECT_EQ(judge({convincing()}, at_once, standing(Standing::kContradicts)).status, MatchStatus::kMatched);
}

TEST(Judge, ProofThatNothingFitsIsNoMatch) {
  search::SearchResult result;
  result.exact = result.certified = true;
  result.total_cells = 1000;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_NE(reasonOf(result).find("0.3 of the 1000"), std::string::npos) << reasonOf(result);
}

TEST(Judge, ListsAllThatItLookedAt) {
  Circumstances circumstances = standing(Standing::kAgrees);
  circumstances.nearby = Surroundings{100, 5.0, 0.9, 100, 5.0, 0.95};

  const Answer answer = judge({convincing()}, {}, circumstances);

  std::vector<std::string> names;
  for (const Evidence& piece : answer.evidence) {
    names.push_back(piece.name);
    EXPECT_EQ(piece.bearing, Bearing::kFor) << piece.name << ": " << piece.text;
    EXPECT_FALSE(piece.text.empty()) << piece.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"proof", "hit_ratio", "margin", "agreement", "nearby_ratio",
                                             "nearby_walls_ratio"}));
  EXPECT_DOUBLE_EQ(find(answer.evidence, "hit_ratio")->value, 0.8);
  EXPECT_DOUBLE_EQ(find(answer.evidence, "hit_ratio")->limit, 0.3);
}

TEST(Judge, LetsTheFirstObjectionDecide) {
  search::SearchResult result = convincing();
  result.hit_cells = 200;
  result.hit_ratio = 0.2;
  result.margin = 0.0;
  result.runner_up_proven = false;

  const Answer answer = judge({result}, {}, standing(Standing::kContradicts));

  EXPECT_EQ(answer.status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_EQ(find(answer.evidence, "margin")->bearing, Bearing::kAgainst);
  EXPECT_EQ(find(answer.evidence, "agreement")->bearing, Bearing::kAgainst);
}

TEST(Judge, TakesTheAnswerOfASearchWithoutProofAsItIs) {
  search::SearchResult result;
  result.found = true;
  result.ratio = 0.7;
  result.reason = "70 of 100 session cells lie on walls at 0.05 m";
  search::SearchResult nothing;
  nothing.reason = "no pose";
  search::SearchResult late = nothing;
  late.ending = search::SearchEnding::kOutOfTime;

  EXPECT_EQ(judge({result}, {}).status, MatchStatus::kMatched);
  EXPECT_EQ(judge({result}, {}).reason, result.reason);
  EXPECT_EQ(judge({nothing}, {}).status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_EQ(judge({late}, {}).status, MatchStatus::kNotCertified);
}

TEST(Judge, SaysWhyNothingWasSearched) {
  using search::SearchEnding;
  for (const auto& [ending, status] :
       {std::make_pair(SearchEnding::kStopped, MatchStatus::kStopped),
        std::make_pair(SearchEnding::kEmptyReference, MatchStatus::kEmptyReference),
        std::make_pair(SearchEnding::kTooFewSessionCells, MatchStatus::kTooFewSessionCells),
        std::make_pair(SearchEnding::kSessionTooLarge, MatchStatus::kSessionTooLarge)}) {
    search::SearchResult result = convincing();
    result.ending = ending;
    result.reason = "why";

    const Answer answer = judge({result}, {});

    EXPECT_EQ(answer.status, status);
    EXPECT_EQ(answer.reason, "why");
    EXPECT_FALSE(answer.alignment());
    EXPECT_TRUE(answer.evidence.empty());
  }
}

}  // namespace
}  // namespace map_matcher::belief
