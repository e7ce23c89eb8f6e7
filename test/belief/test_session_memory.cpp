#include <gtest/gtest.h>

#include "map_matcher/belief/session_memory.hpp"

namespace map_matcher::belief {
namespace {

search::MatchResult answer(search::MatchStatus status, double x) {
  search::MatchResult result;
  result.status = status;
  result.T_reference_session = {x, 0.0, 0.0};
  return result;
}

TEST(SessionMemory, KnowsNothingAtFirst) {
  const SessionMemory memory;
  EXPECT_FALSE(memory.prior().alignment.has_value());
  EXPECT_FALSE(memory.prior().contender.has_value());
}

TEST(SessionMemory, KeepsTheLastAcceptedAlignment) {
  SessionMemory memory;
  memory.add(answer(search::MatchStatus::kMatched, 1.0));
  memory.add(answer(search::MatchStatus::kMatched, 2.0));
  memory.add(answer(search::MatchStatus::kAmbiguous, 9.0));

  EXPECT_EQ(memory.prior().alignment->x, 2.0);
  EXPECT_FALSE(memory.prior().contender.has_value());
}

TEST(SessionMemory, KeepsAContenderUntilTheNextAnswerOfASearch) {
  for (const search::MatchStatus status :
       {search::MatchStatus::kMatched, search::MatchStatus::kBelowAcceptanceRatio, search::MatchStatus::kNotCertified,
        search::MatchStatus::kAmbiguous, search::MatchStatus::kRobotAstray}) {
    SessionMemory memory;
    memory.add(answer(search::MatchStatus::kMatched, 1.0));
    memory.add(answer(search::MatchStatus::kUnconfirmed, 7.0));
    memory.add(answer(search::MatchStatus::kTooFewSessionCells, 0.0));
    memory.add(answer(search::MatchStatus::kStopped, 0.0));

    ASSERT_TRUE(memory.prior().contender.has_value());
    EXPECT_EQ(memory.prior().contender->x, 7.0);
    EXPECT_EQ(memory.prior().alignment->x, 1.0);

    memory.add(answer(status, 3.0));
    EXPECT_FALSE(memory.prior().contender.has_value()) << toString(status);
  }
}

TEST(SessionMemory, KnowsThatTheRobotWasLostUntilAMapFitsAroundIt) {
  SessionMemory memory;
  memory.add(answer(search::MatchStatus::kMatched, 1.0));
  EXPECT_FALSE(memory.prior().robot_astray);

  memory.add(answer(search::MatchStatus::kRobotAstray, 2.0));
  memory.add(answer(search::MatchStatus::kAmbiguous, 3.0));
  EXPECT_TRUE(memory.prior().robot_astray);
  EXPECT_EQ(memory.prior().alignment->x, 1.0);

  memory.add(answer(search::MatchStatus::kMatched, 1.0));
  EXPECT_FALSE(memory.prior().robot_astray);
}

TEST(SessionMemory, ForgetsAll) {
  SessionMemory memory;
  memory.add(answer(search::MatchStatus::kMatched, 1.0));
  memory.add(answer(search::MatchStatus::kUnconfirmed, 7.0));

  memory.clear();

  EXPECT_FALSE(memory.prior().alignment.has_value());
  EXPECT_FALSE(memory.prior().contender.has_value());
}

}  // namespace
}  // namespace map_matcher::belief
