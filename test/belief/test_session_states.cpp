// What a session comes to, map by map, when its places are known with all the evidence for them.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "map_matcher/belief/probability.hpp"
#include "map_matcher/belief/session_tracker.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kHere = 3.0;        // [m]
constexpr double kElsewhere = 20.0;  // [m]

Candidate candidate(double x, double hit_ratio) {
  Candidate result;
  result.place.T_reference_session = result.place.searched = {x, 0.0, 0.0};
  result.place.hit_ratio = hit_ratio;
  result.place.hit_cells = static_cast<int>(hit_ratio * 1000);
  result.space = {20.0, 0.0, 20.0, 0.0};
  result.worth = hit_ratio;
  return result;
}

/// Places with these hits, and nothing else anywhere.
Findings found(const std::vector<Candidate>& candidates) {
  search::SearchResult result;
  result.exact = result.found = result.certified = true;
  result.total_cells = 1000;
  result.upper_bound = 1.0;
  result.elsewhere_bound = 0.2;
  return rank({result}, candidates, demandOf({}).margin);
}

Findings followed(double x, double hit_ratio) {
  Findings findings = found({candidate(x, hit_ratio)});
  findings.search.exact = findings.search.certified = false;
  findings.followed = true;
  return findings;
}

grid::OccupancyGrid sessionMap(int number) {
  grid::OccupancyGrid map = test::asciiMap({"????????"});
  map.at(number, 0) = grid::kOccupied;
  return map;
}

Prior supposed(double x) { return {grid::Rigid2{x, 0.0, 0.0}, 0.25 * Eigen::Matrix3d::Identity(), "initialpose"}; }

class SessionStates : public testing::Test {
 protected:
  Decision conclude(const Findings& findings, int map) {
    return tracker_.conclude(findings, {&reference_}, sessionMap(map), std::nullopt);
  }

  search::Reference reference_{test::asciiMap({"####"}), {}};
  SessionTracker tracker_{MatchOptions{}};
};

TEST_F(SessionStates, AreSearchingUntilAPlaceIsMatched) {
  EXPECT_EQ(tracker_.state(), SessionState::kSearching);

  const Decision ambiguous = conclude(found({candidate(kHere, 0.8), candidate(kElsewhere, 0.78)}), 1);
  const Decision clear = conclude(found({candidate(kHere, 0.8)}), 2);

  EXPECT_EQ(ambiguous.answer.status, MatchStatus::kAmbiguous) << ambiguous.answer.reason;
  EXPECT_EQ(ambiguous.state, SessionState::kSearching);
  EXPECT_EQ(clear.answer.status, MatchStatus::kMatched) << clear.answer.reason;
  EXPECT_EQ(clear.state, SessionState::kLocalized);
}

TEST_F(SessionStates, AreTentativeUntilAnotherMapAgreesWithADoubtfulPlace) {
  const Findings here = found({candidate(kHere, 0.8)});
  MatchOptions options;
  options.belief.min_probability = probabilityOf(here) + 1e-4;
  options.belief.tentative_probability = probabilityOf(here) - 1e-4;
  tracker_ = SessionTracker(options);

  const Decision first = conclude(here, 1);
  const Decision same_map = conclude(here, 1);
  const Decision second = conclude(here, 2);

  EXPECT_EQ(first.answer.status, MatchStatus::kDoubtful) << first.answer.reason;
  EXPECT_EQ(first.state, SessionState::kTentative);
  EXPECT_EQ(first.broadcast, Broadcast::kKeep);
  EXPECT_EQ(same_map.answer.status, MatchStatus::kDoubtful) << "a map does not confirm itself";
  EXPECT_EQ(second.answer.status, MatchStatus::kMatched) << second.answer.reason;
  EXPECT_EQ(second.state, SessionState::kLocalized);
}

TEST_F(SessionStates, ForgetADoubtfulPlaceThatTheNextMapDoesNotFind) {
  const Findings here = found({candidate(kHere, 0.8)});
  MatchOptions options;
  options.belief.min_probability = probabilityOf(here) + 1e-4;
  tracker_ = SessionTracker(options);

  conclude(here, 1);
  const Decision elsewhere = conclude(found({candidate(kElsewhere, 0.8)}), 2);
  const Decision back = conclude(here, 3);

  EXPECT_EQ(elsewhere.answer.status, MatchStatus::kDoubtful);
  EXPECT_EQ(back.answer.status, MatchStatus::kDoubtful);
}

TEST_F(SessionStates, FollowThePlaceInUseAndProveItNowAndThen) {
  MatchOptions options;
  options.belief.maps_per_proof = 3;
  tracker_ = SessionTracker(options);
  EXPECT_FALSE(tracker_.plan().follow);

  const Decision proven = conclude(found({candidate(kHere, 0.8)}), 1);
  ASSERT_TRUE(tracker_.plan().follow);
  EXPECT_EQ(tracker_.plan().follow->T_reference_session.x, kHere);
  EXPECT_DOUBLE_EQ(tracker_.plan().worth, 0.8);
  const Decision drifted = conclude(followed(kHere + 0.1, 0.75), 2);
  EXPECT_EQ(tracker_.plan().follow->T_reference_session.x, kHere + 0.1);
  conclude(followed(kHere + 0.2, 0.75), 3);

  EXPECT_EQ(drifted.answer.status, MatchStatus::kMatched) << drifted.answer.reason;
  EXPECT_EQ(drifted.broadcast, Broadcast::kReplace);
  EXPECT_DOUBLE_EQ(drifted.answer.probability, proven.answer.probability) << "that of the last proof";
  EXPECT_NE(find(drifted.answer.evidence, "followed"), nullptr);
  EXPECT_FALSE(tracker_.plan().follow) << "the third of three maps is searched as a whole";
}

std::vector<double> startsOf(const Plan& plan) {
  std::vector<double> starts;
  for (const KnownPlace& place : plan.starts) {
    starts.push_back(place.T_reference_session.x);
  }
  return starts;
}

TEST_F(SessionStates, LetTheNextSearchBeginInThePlacesOfTheLastMap) {
  Findings unproven = found({candidate(kHere, 0.8), candidate(kElsewhere, 0.78)});
  unproven.results.front().certified = unproven.search.certified = false;
  EXPECT_TRUE(startsOf(tracker_.plan()).empty());

  conclude(unproven, 1);
  EXPECT_EQ(startsOf(tracker_.plan()), std::vector<double>({kHere, kElsewhere}));
  conclude(found({}), 2);
  EXPECT_EQ(startsOf(tracker_.plan()), std::vector<double>({kHere, kElsewhere})) << "a search that found nothing";
  tracker_.suppose(supposed(7.0));
  EXPECT_EQ(startsOf(tracker_.plan()), std::vector<double>({kHere, kElsewhere, 7.0}));
  tracker_.reset();
  EXPECT_TRUE(startsOf(tracker_.plan()).empty());
}

TEST_F(SessionStates, LetAProofBeginInThePlaceThatWasFollowed) {
  conclude(found({candidate(kHere, 0.8)}), 1);

  conclude(followed(kHere + 0.1, 0.75), 2);

  EXPECT_EQ(startsOf(tracker_.plan()), std::vector<double>({kHere + 0.1, kHere}));
}

TEST_F(SessionStates, StayWhereTheyAreWithinTheDeviationOfAMap) {
  const auto nearby = [](double x) {
    Findings findings = followed(x, 0.8);
    findings.search.covariance = Eigen::Vector3d(0.02 * 0.02, 0.02 * 0.02, 1e-4).asDiagonal();
    return findings;
  };
  conclude(found({candidate(kHere, 0.8)}), 1);

  const Decision within = conclude(nearby(kHere + 0.03), 2);
  const Decision beyond = conclude(nearby(kHere + 0.05), 3);
  const Decision from_there = conclude(nearby(kHere + 0.03), 4);

  EXPECT_EQ(within.answer.search.T_reference_session.x, kHere);
  EXPECT_EQ(within.broadcast, Broadcast::kReplace) << "it was seen again";
  EXPECT_EQ(beyond.answer.search.T_reference_session.x, kHere + 0.05);
  EXPECT_EQ(from_there.answer.search.T_reference_session.x, kHere + 0.05);
  EXPECT_EQ(from_there.maps_since_proof, 3);
}

TEST_F(SessionStates, AreAboutTheFloorThatIsMeant) {
  Candidate above = candidate(kHere, 0.79);
  above.map = 1;
  const Findings equal =
      rank({found({}).search, found({}).search}, {candidate(kHere, 0.8), above}, demandOf({}).margin);
  tracker_.suppose({{grid::Rigid2{kHere, 0.0, 0.0}, 1}, 0.25 * Eigen::Matrix3d::Identity(), "initialpose"});

  const Decision decision = tracker_.conclude(equal, {&reference_, &reference_}, sessionMap(1), std::nullopt);

  EXPECT_EQ(decision.answer.status, MatchStatus::kMatched) << decision.answer.reason;
  EXPECT_EQ(decision.answer.map, 1U);
}

TEST_F(SessionStates, KeepThePlaceInUseUnlessAnotherIsClearlyWorthMore) {
  conclude(found({candidate(kHere, 0.8)}), 1);

  const Decision nearly_equal = conclude(found({candidate(kElsewhere, 0.8), candidate(kHere, 0.75)}), 2);
  const Decision better = conclude(found({candidate(kElsewhere, 0.9), candidate(kHere, 0.5)}), 3);
  const Decision again = conclude(found({candidate(kElsewhere, 0.9), candidate(kHere, 0.5)}), 4);

  EXPECT_EQ(nearly_equal.answer.status, MatchStatus::kMatched) << nearly_equal.answer.reason;
  EXPECT_EQ(nearly_equal.answer.search.T_reference_session.x, kHere);
  EXPECT_EQ(better.answer.status, MatchStatus::kUnconfirmed) << better.answer.reason;
  EXPECT_EQ(again.answer.status, MatchStatus::kMatched) << again.answer.reason;
  EXPECT_EQ(again.answer.search.T_reference_session.x, kElsewhere);
}

TEST_F(SessionStates, LetSomebodyDecideBetweenEqualPlaces) {
  const Findings equal = found({candidate(kHere, 0.8), candidate(kElsewhere, 0.79)});

  const Decision alone = conclude(equal, 1);
  tracker_.suppose(supposed(kElsewhere + 0.5));
  const Decision helped = conclude(equal, 1);

  EXPECT_EQ(alone.answer.status, MatchStatus::kAmbiguous);
  EXPECT_EQ(helped.answer.status, MatchStatus::kMatched) << helped.answer.reason;
  EXPECT_EQ(helped.answer.search.T_reference_session.x, kElsewhere);
  EXPECT_EQ(find(helped.answer.evidence, "prior")->bearing, Bearing::kFor);
}

TEST_F(SessionStates, ObeyNobodyAgainstTheEvidence) {
  tracker_.suppose(supposed(kElsewhere));

  const Decision decision = conclude(found({candidate(kHere, 0.8), candidate(kElsewhere, 0.4)}), 1);

  EXPECT_EQ(decision.answer.status, MatchStatus::kMatched) << decision.answer.reason;
  EXPECT_EQ(decision.answer.search.T_reference_session.x, kHere);
  EXPECT_EQ(find(decision.answer.evidence, "prior")->bearing, Bearing::kSilent);
}

TEST_F(SessionStates, ProveAPlaceAnewThatSomebodyDoesNotMean) {
  conclude(found({candidate(kHere, 0.8)}), 1);
  ASSERT_TRUE(tracker_.plan().follow);

  tracker_.suppose(supposed(kElsewhere));

  EXPECT_FALSE(tracker_.plan().follow);
  const Decision decision = conclude(found({candidate(kHere, 0.8)}), 2);
  EXPECT_EQ(decision.answer.search.T_reference_session.x, kHere);
  EXPECT_EQ(decision.state, SessionState::kLocalized);
}

}  // namespace
}  // namespace map_matcher::belief
