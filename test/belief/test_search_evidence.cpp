// What the search says of a place when there may be others that it did not find.
#include <gtest/gtest.h>

#include "map_matcher/belief/prior.hpp"
#include "map_matcher/belief/search_evidence.hpp"
#include "map_matcher/belief/session_tracker.hpp"
#include "support/ascii_map.hpp"

namespace map_matcher::belief {
namespace {

/// A place that is seen through over so many of 10 m of wall.
Candidate candidate(double x, double hit_ratio, double seen_through) {
  Candidate result;
  result.place.T_reference_session = result.place.searched = {x, 0.0, 0.0};
  result.place.hit_ratio = hit_ratio;
  result.place.hit_cells = static_cast<int>(hit_ratio * 1000);
  result.space = {30.0, 0.0, 30.0 * (1.0 - seen_through / 10.0), 30.0 * seen_through / 10.0};
  result.worth = worthOf(hit_ratio, result.space);
  return result;
}

/// Candidates, and any number of places elsewhere with up to this share of hits.
Findings found(const std::vector<Candidate>& candidates, double elsewhere_bound) {
  search::SearchResult result;
  result.exact = result.found = result.certified = true;
  result.total_cells = 1000;
  result.upper_bound = 0.8;
  result.elsewhere_bound = elsewhere_bound;
  return rank({result}, candidates, demandOf({}).margin);
}

TEST(MarginEvidence, SpeaksForAPlaceThatNoneCanComeNearToThoughNotAllWereFound) {
  const Findings findings = found({candidate(1.0, 0.8, 0.0), candidate(9.0, 0.7, 4.0)}, 0.68);

  EXPECT_FALSE(findings.search.runner_up_proven) << "another one may be worth more than the second";
  EXPECT_NEAR(provenLeadOf(findings), 0.12, 1e-9);
  const Evidence evidence = marginEvidence(findings, {}, false);
  EXPECT_EQ(evidence.bearing, Bearing::kFor) << evidence.text;
  EXPECT_EQ(evidence.text, "no place elsewhere comes closer to its ratio than 0.12");
}

TEST(MarginEvidence, DoesNotWhereOneThatWasNotFoundMayBeWorthNearlyAsMuch) {
  const Evidence near = marginEvidence(found({candidate(1.0, 0.8, 0.0)}, 0.72), {}, false);
  const Findings ahead_in_hits_alone = found({candidate(1.0, 0.8, 4.0), candidate(9.0, 0.69, 8.0)}, 0.68);

  EXPECT_EQ(near.bearing, Bearing::kAgainst);
  EXPECT_EQ(near.objection, MatchStatus::kNotCertified);
  EXPECT_LT(provenLeadOf(ahead_in_hits_alone), 0.0);
  EXPECT_FALSE(ahead_in_hits_alone.search.runner_up_proven);
  EXPECT_EQ(marginEvidence(ahead_in_hits_alone, {}, false).objection, MatchStatus::kNotCertified);
}

TEST(MarginEvidence, CountsPlacesThatWereNotFoundAsThoughTheyWereInUseOrMeant) {
  const search::Reference reference(test::asciiMap({"####"}), {});
  const grid::OccupancyGrid map = test::asciiMap({"???#????"});
  const auto statusOf = [&](SessionTracker tracker, const Findings& findings) {
    return tracker.conclude(findings, {&reference}, map, std::nullopt).answer.status;
  };
  const Findings ahead = found({candidate(1.0, 0.8, 0.0), candidate(9.0, 0.7, 4.0)}, 0.6);
  const Findings nearly = found({candidate(1.0, 0.8, 0.0), candidate(9.0, 0.7, 4.0)}, 0.68);
  SessionTracker helped{MatchOptions{}};
  helped.suppose({grid::Rigid2{20.0, 0.0, 0.0}, 0.25 * Eigen::Matrix3d::Identity(), "initialpose"});

  EXPECT_EQ(statusOf(SessionTracker{MatchOptions{}}, nearly), MatchStatus::kMatched);
  EXPECT_EQ(statusOf(helped, nearly), MatchStatus::kNotCertified);
  EXPECT_EQ(statusOf(helped, ahead), MatchStatus::kMatched);
}

}  // namespace
}  // namespace map_matcher::belief
