#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "map_matcher/belief/judge.hpp"
#include "map_matcher/belief/place_search.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kResolution = 0.05;

/// Floors with different walls, and a session map of one of them.
class Floors : public testing::Test {
 protected:
  static grid::OccupancyGrid building(std::uint32_t seed) {
    std::mt19937 random(seed);
    return test::randomBuilding(random, 16.0, 10.0, kResolution);
  }

  Floors() {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      floors_.push_back(std::make_unique<search::Reference>(building(seed), options_.search));
      maps_.push_back(floors_.back().get());
    }
    session_.push_back(test::cutSession(floors_[1]->grid(), {8.0, 5.0}, 7.0, truth_, kResolution));
  }

  Findings find(const Plan& plan = {}) const { return findPlaces(matcher_, maps_, session_.front(), options_, plan); }

  double error(const grid::Rigid2& T_reference_session) const {
    const grid::Rigid2 error = truth_.inverse() * T_reference_session;
    return std::hypot(error.x, error.y) + 3.5 * std::abs(error.yaw);
  }

  MatchOptions options_;
  search::MapMatcher matcher_{options_.search};
  std::vector<std::unique_ptr<search::Reference>> floors_;
  ReferenceMaps maps_;
  grid::Rigid2 truth_{2.0, -1.0, 0.8};
  std::vector<grid::OccupancyGrid> session_;
};

TEST_F(Floors, AreToldApartAndTheRightOneIsProvenOverAll) {
  const Findings findings = find();
  const Answer answer = judge(findings, options_);

  EXPECT_EQ(findings.map, 1U);
  EXPECT_EQ(answer.map, 1U);
  EXPECT_TRUE(answer.matched()) << answer.reason;
  EXPECT_LT(error(answer.search.T_reference_session), 0.15);
  EXPECT_EQ(findings.results.size(), 3U);
}

TEST_F(Floors, AreToldApartInAnyOrder) {
  const Findings findings = find();
  std::sort(maps_.begin(), maps_.end());
  do {
    const Findings again = find();

    EXPECT_EQ(maps_.at(again.map), floors_[1].get());
    EXPECT_LT(error(again.search.T_reference_session), 0.15);
    EXPECT_TRUE(again.search.certified);
    EXPECT_GE(again.search.margin, demandOf(options_).margin - 1e-9) << "as much as is asked for is proven";
    EXPECT_EQ(again.search.hit_cells, findings.search.hit_cells);
  } while (std::next_permutation(maps_.begin(), maps_.end()));
}

TEST_F(Floors, AreSearchedWhereNoneIsEasilyFound) {
  options_.search.coarse.acceptance_ratio = 0.99;

  const Findings findings = findPlaces(search::MapMatcher(options_.search), maps_, session_.front(), options_);

  EXPECT_EQ(findings.map, 1U);
  EXPECT_LT(error(findings.search.T_reference_session), 0.15);
}

TEST_F(Floors, ThatAreAlikeAreAmbiguous) {
  floors_.push_back(std::make_unique<search::Reference>(floors_[1]->grid(), options_.search));
  maps_.push_back(floors_.back().get());

  const Answer answer = judge(find(), options_);

  EXPECT_EQ(answer.status, MatchStatus::kAmbiguous) << answer.reason;
  EXPECT_NEAR(answer.search.margin, 0.0, 1e-9);
}

TEST_F(Floors, AreNotSearchedWhereThePlaceInUseHolds) {
  const Findings whole = find();
  const Plan plan{KnownPlace(whole.search.T_reference_session, whole.map), whole.candidates.front().worth};

  const Findings followed = find(plan);

  EXPECT_TRUE(followed.followed);
  EXPECT_EQ(followed.map, 1U);
  EXPECT_LT(error(followed.search.T_reference_session), 0.15);
}

TEST_F(Floors, AreSearchedWhereThePlaceInUseDoesNotHold) {
  const Plan wrong_place{KnownPlace(grid::Rigid2{5.0, 3.0, 0.3} * truth_, 1), 0.9};
  const Plan wrong_floor{KnownPlace(truth_, 0), 0.9};

  for (const Plan& plan : {wrong_place, wrong_floor}) {
    const Findings findings = find(plan);

    EXPECT_FALSE(findings.followed);
    EXPECT_EQ(findings.map, 1U);
    EXPECT_LT(error(findings.search.T_reference_session), 0.15);
  }
}

}  // namespace
}  // namespace map_matcher::belief
