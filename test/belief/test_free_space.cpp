#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/free_space.hpp"
#include "map_matcher/belief/probability.hpp"

namespace map_matcher::belief {
namespace {

/// Free space of 4 m x 4 m, with a wall along x at each of the rows.
grid::OccupancyGrid room(const std::vector<int>& wall_rows) {
  grid::OccupancyGrid map({0.05, 80, 80, {}});
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) {
      const bool wall = std::find(wall_rows.begin(), wall_rows.end(), y) != wall_rows.end();
      map.at(x, y) = wall ? grid::kOccupied : grid::kFree;
    }
  }
  return map;
}

grid::SeenSpace seen(const grid::OccupancyGrid& map) { return {map, 0.0, grid::kDefaultOccupiedThreshold}; }

TEST(FreeSpace, IsAllAgreementWhereTheMapsAreTheSame) {
  const FreeSpace space = freeSpace(seen(room({10, 60})), seen(room({10, 60})), {});

  EXPECT_NEAR(space.on_walls, 8.0, 1e-9);
  EXPECT_NEAR(space.confirmed, 8.0, 1e-9);
  EXPECT_EQ(space.throughShare(), 0.0);
  EXPECT_EQ(space.openShare(), 0.0);
}

TEST(FreeSpace, TellsTheWallThatWasSeenThroughFromTheOneThatIsNew) {
  const FreeSpace gone = freeSpace(seen(room({10, 60})), seen(room({10})), {});
  const FreeSpace added = freeSpace(seen(room({10})), seen(room({10, 60})), {});

  EXPECT_NEAR(gone.seen_through, 4.0, 1e-9);
  EXPECT_NEAR(gone.throughShare(), 0.5, 1e-9);
  EXPECT_EQ(gone.openShare(), 0.0);
  EXPECT_NEAR(added.in_the_open, 4.0, 1e-9);
  EXPECT_EQ(added.throughShare(), 0.0);
}

TEST(FreeSpace, SaysNothingOfWhatOneMapDoesNotKnow) {
  const grid::OccupancyGrid unknown({0.05, 80, 80, {}});

  const FreeSpace space = freeSpace(seen(room({10, 60})), seen(unknown), {});

  EXPECT_EQ(space.agreeing(), 0.0);
  EXPECT_EQ(space.throughShare(), 0.0);
}

TEST(FreeSpace, LaysTheSessionWhereItIs) {
  const grid::Rigid2 T_reference_session{0.0, 1.0, 0.0};

  const FreeSpace space = freeSpace(seen(room({40})), seen(room({20})), T_reference_session);

  EXPECT_NEAR(space.on_walls, 4.0, 1e-9);
  EXPECT_EQ(space.seen_through, 0.0);
}

TEST(Worth, NeverExceedsTheHits) {
  EXPECT_DOUBLE_EQ(worthOf(0.8, {10.0, 90.0, 10.0, 0.0}), 0.8) << "people are no argument";
  EXPECT_DOUBLE_EQ(worthOf(0.8, {10.0, 0.0, 10.0, 10.0}), 0.55);
}

TEST(Probability, RisesWithWhatSpeaksForAPlaceAndFallsWithWhatSpeaksAgainst) {
  const double here = probabilityOf({0.1, 0.1, 10.0});

  EXPECT_GT(probabilityOf({0.15, 0.1, 10.0}), here);
  EXPECT_LT(probabilityOf({0.1, 0.2, 10.0}), here);
  EXPECT_GT(probabilityOf({0.1, 0.1, 20.0}), here);
  EXPECT_DOUBLE_EQ(probabilityOf({kLargestMargin + 0.3, 0.1, 10.0}), probabilityOf({kLargestMargin, 0.1, 10.0}));
  EXPECT_EQ(probabilityOf(Findings{}), 0.0);
}

/// A candidate with these hits and walls seen through.
Candidate candidate(double x, double hit_ratio, double seen_through) {
  Candidate result;
  result.place.T_reference_session = result.place.searched = {x, 0.0, 0.0};
  result.place.hit_ratio = hit_ratio;
  result.space = {10.0, 0.0, 10.0 - seen_through, seen_through};
  result.worth = worthOf(hit_ratio, result.space);
  return result;
}

search::SearchResult certified(double elsewhere_bound) {
  search::SearchResult result;
  result.exact = result.found = result.certified = true;
  result.total_cells = 1000;
  result.upper_bound = 0.8;
  result.elsewhere_bound = elsewhere_bound;
  return result;
}

TEST(Rank, PutsThePlaceThatIsWorthMostFirstAndTellsItsLead) {
  const Findings findings = rank({certified(0.5)}, {candidate(1.0, 0.8, 6.0), candidate(9.0, 0.7, 0.0)}, 0.1);

  EXPECT_EQ(findings.search.T_reference_session.x, 9.0);
  EXPECT_DOUBLE_EQ(findings.search.hit_ratio, 0.7);
  EXPECT_NEAR(findings.search.margin, 0.2, 1e-9);
  EXPECT_TRUE(findings.search.runner_up_proven);
}

TEST(Rank, CountsPlacesThatWereNotFoundForWhatTheyMayBeWorth) {
  const Findings findings = rank({certified(0.65)}, {candidate(9.0, 0.7, 0.0)}, 0.1);

  EXPECT_NEAR(findings.search.margin, 0.05, 1e-9);
  EXPECT_FALSE(findings.search.runner_up_proven);
  EXPECT_FALSE(findings.search.runner_up);
}

TEST(Rank, ComparesPlacesOfSeveralMaps) {
  Candidate upstairs = candidate(3.0, 0.75, 0.0);
  upstairs.map = 1;

  const Findings findings = rank({certified(0.3), certified(0.6)}, {candidate(1.0, 0.7, 0.0), upstairs}, 0.1);

  EXPECT_EQ(findings.map, 1U);
  EXPECT_EQ(findings.search.T_reference_session.x, 3.0);
  ASSERT_TRUE(findings.search.runner_up);
  EXPECT_NEAR(findings.search.margin, 0.05, 1e-9);
}

TEST(Rank, ClaimsNoLeadWithoutAProof) {
  search::SearchResult unproven = certified(1.0);
  unproven.certified = false;

  const Findings findings = rank({unproven}, {candidate(9.0, 0.7, 0.0)}, 0.1);

  EXPECT_EQ(findings.search.margin, 0.0);
  EXPECT_FALSE(findings.search.runner_up_proven);
}

}  // namespace
}  // namespace map_matcher::belief
