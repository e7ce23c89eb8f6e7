#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "map_matcher/belief/session_tracker.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::belief {
namespace {

/// What a search says of a map.
enum class Found { kPlace, kNothing, kTwoPlaces, kTooFewCells };

/// A map of the session, what the search says of it, and what is to come of it.
struct Step {
  int map;  ///< Maps of one number are the same, cell by cell.
  Found found;
  double x;  ///< Of the place that was found [m].
  MatchStatus status;
  Broadcast broadcast;
};

grid::OccupancyGrid sessionMap(int number) {
  grid::OccupancyGrid map = test::asciiMap({"????????????????"});
  for (int bit = 0; bit < 16; ++bit) {
    map.at(bit, 0) = (number >> bit) % 2 == 1 ? grid::kOccupied : grid::kFree;
  }
  return map;
}

search::SearchResult resultOf(Found found, double x) {
  search::SearchResult result;
  result.exact = true;
  result.total_cells = 1000;
  if (found == Found::kTooFewCells) {
    result.ending = search::SearchEnding::kTooFewSessionCells;
    return result;
  }
  result.certified = result.runner_up_proven = true;
  if (found != Found::kNothing) {
    result.found = true;
    result.T_reference_session = {x, 0.0, 0.0};
    result.hit_cells = 800;
    result.hit_ratio = result.upper_bound = 0.8;
    result.margin = found == Found::kPlace ? 0.3 : 0.0;
  }
  if (found == Found::kTwoPlaces) {
    result.runner_up = search::RunnerUp{{x + 6.0, 0.0, 0.0}, 0.8};
  }
  return result;
}

class TrackerTable : public testing::Test {
 protected:
  void run(const std::vector<Step>& steps) {
    int row = 0;
    for (const Step& step : steps) {
      SCOPED_TRACE("row " + std::to_string(row++));

      const Decision decision =
          tracker_.conclude({resultOf(step.found, step.x)}, {&reference_}, sessionMap(step.map), std::nullopt);

      EXPECT_EQ(decision.answer.status, step.status) << decision.answer.reason;
      EXPECT_EQ(decision.broadcast, step.broadcast);
    }
  }

  search::Reference reference_{test::asciiMap({"####"}), {}};
  SessionTracker tracker_{MatchOptions{}};
};

TEST_F(TrackerTable, KeepsTheAlignmentUntilALaterMapIsMatched) {
  run({{1, Found::kNothing, 0.0, MatchStatus::kBelowAcceptanceRatio, Broadcast::kKeep},
       {2, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace},
       {3, Found::kNothing, 0.0, MatchStatus::kBelowAcceptanceRatio, Broadcast::kKeep},
       {4, Found::kPlace, 3.1, MatchStatus::kMatched, Broadcast::kReplace}});

  EXPECT_EQ(tracker_.alignment()->T_reference_session.x, 3.1);
}

TEST_F(TrackerTable, FollowsAPlaceThatHasARival) {
  run({{1, Found::kTwoPlaces, 3.0, MatchStatus::kAmbiguous, Broadcast::kKeep},
       {2, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace},
       {3, Found::kTwoPlaces, 3.2, MatchStatus::kMatched, Broadcast::kReplace},
       {4, Found::kTwoPlaces, 9.0, MatchStatus::kAmbiguous, Broadcast::kKeep}});
}

TEST_F(TrackerTable, GivesUpAPlaceForOneThatTwoMapsInARowFind) {
  run({{1, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace},
       {2, Found::kPlace, 9.0, MatchStatus::kUnconfirmed, Broadcast::kKeep},
       {3, Found::kPlace, 9.1, MatchStatus::kMatched, Broadcast::kReplace}});
}

TEST_F(TrackerTable, BelievesNoMapThatConfirmsItself) {
  run({{1, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace},
       {2, Found::kPlace, 9.0, MatchStatus::kUnconfirmed, Broadcast::kKeep},
       {2, Found::kPlace, 9.0, MatchStatus::kUnconfirmed, Broadcast::kKeep},
       {2, Found::kPlace, 9.0, MatchStatus::kUnconfirmed, Broadcast::kKeep},
       {3, Found::kPlace, 9.0, MatchStatus::kMatched, Broadcast::kReplace}});
}

TEST_F(TrackerTable, ForgetsAContenderThatTheNextSearchDoesNotFind) {
  run({{1, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace},
       {2, Found::kPlace, 9.0, MatchStatus::kUnconfirmed, Broadcast::kKeep},
       {3, Found::kNothing, 0.0, MatchStatus::kBelowAcceptanceRatio, Broadcast::kKeep},
       {4, Found::kPlace, 9.0, MatchStatus::kUnconfirmed, Broadcast::kKeep},
       {5, Found::kTooFewCells, 0.0, MatchStatus::kTooFewSessionCells, Broadcast::kKeep},  // not searched
       {6, Found::kPlace, 9.0, MatchStatus::kMatched, Broadcast::kReplace}});
}

TEST_F(TrackerTable, BelievesTheFirstPlaceOfANewSessionAtOnce) {
  tracker_.arrive({"session_map", "/mapper", 1.0, 0.05, 5000});
  run({{1, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace}});

  EXPECT_EQ(tracker_.arrive({"session_map", "/mapper", 2.0, 0.05, 5100}), "");
  EXPECT_TRUE(tracker_.alignment());
  EXPECT_NE(tracker_.arrive({"session_map", "/mapper", 3.0, 0.05, 400}), "");
  EXPECT_FALSE(tracker_.alignment());

  run({{2, Found::kPlace, 9.0, MatchStatus::kMatched, Broadcast::kReplace}});
}

TEST_F(TrackerTable, KnowsAMapperThatBeginsAnewWhateverWasForgotten) {
  tracker_.arrive({"session_map", "/mapper", 1.0, 0.05, 5000});
  tracker_.reset();  // another reference map came after the session map
  run({{1, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace}});

  EXPECT_NE(tracker_.arrive({"session_map", "/mapper", 2.0, 0.05, 400}), "");
  EXPECT_FALSE(tracker_.alignment());
}

TEST_F(TrackerTable, ForgetsAllWhenItIsReset) {
  run({{1, Found::kPlace, 3.0, MatchStatus::kMatched, Broadcast::kReplace},
       {2, Found::kPlace, 9.0, MatchStatus::kUnconfirmed, Broadcast::kKeep}});

  tracker_.reset();

  EXPECT_FALSE(tracker_.alignment());
  run({{3, Found::kPlace, 20.0, MatchStatus::kMatched, Broadcast::kReplace}});
}

/// A long wall, and free space before it.
grid::OccupancyGrid wallMap(int wall_row) {
  grid::OccupancyGrid map({0.05, 100, 60, {}});
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 60; ++y) {
      map.at(x, y) = y == wall_row ? grid::kOccupied : grid::kFree;
    }
  }
  return map;
}

TEST(SessionTracker, WithdrawsTheAlignmentWhileTheMapDoesNotFitAroundTheRobot) {
  const search::Reference reference(wallMap(30), {});
  SessionTracker tracker{MatchOptions{}};
  const search::SearchResult here = resultOf(Found::kPlace, 0.0);
  const Eigen::Vector2d robot(2.5, 1.0);

  const Decision at_home = tracker.conclude({here}, {&reference}, wallMap(30), robot);
  const Decision lost = tracker.conclude({here}, {&reference}, wallMap(45), robot);
  const Decision unseen = tracker.conclude({here}, {&reference}, wallMap(45), Eigen::Vector2d(500.0, 500.0));
  const Decision unknown = tracker.conclude({here}, {&reference}, wallMap(45), std::nullopt);

  EXPECT_EQ(at_home.broadcast, Broadcast::kReplace) << at_home.answer.reason;
  EXPECT_EQ(lost.answer.status, MatchStatus::kRobotLost) << lost.answer.reason;
  EXPECT_EQ(lost.broadcast, Broadcast::kWithdraw);
  EXPECT_EQ(unseen.answer.status, MatchStatus::kRobotLost) << "what cannot be seen takes nothing back";
  EXPECT_EQ(unknown.answer.status, MatchStatus::kRobotLost) << "nor does a robot whose place is not known";
}

TEST(SessionTracker, OnlyTellsOfARobotThatIsLostWhereThatIsAskedFor) {
  const search::Reference reference(wallMap(30), {});
  MatchOptions options;
  options.belief.withdraw_when_lost = false;
  SessionTracker tracker{options};
  const search::SearchResult here = resultOf(Found::kPlace, 0.0);
  const Eigen::Vector2d robot(2.5, 1.0);
  tracker.conclude({here}, {&reference}, wallMap(30), robot);

  const Decision lost = tracker.conclude({here}, {&reference}, wallMap(45), robot);

  EXPECT_EQ(lost.answer.status, MatchStatus::kRobotLost) << lost.answer.reason;
  EXPECT_EQ(lost.broadcast, Broadcast::kKeep);
  EXPECT_EQ(lost.state, SessionState::kLost);
}

}  // namespace
}  // namespace map_matcher::belief
