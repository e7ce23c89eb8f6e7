// Following a place from session map to session map. The seeds are fixed and named in every failure.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include "map_matcher/search/map_matcher.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

constexpr double kResolution = 0.05;

/// A building that the session maps of a drive are cut out of.
struct Scene {
  explicit Scene(std::uint32_t seed)
      : random(seed), building(test::randomBuilding(random, 20.0, 12.0, kResolution)), reference(building, {}) {}

  SearchResult follow(const grid::OccupancyGrid& session, const grid::Rigid2& T_reference_session,
                      const Demand& demand = {}) const {
    return MapMatcher().follow(reference, session, T_reference_session, demand);
  }

  std::mt19937 random;
  grid::OccupancyGrid building;
  Reference reference;
};

double apart(const grid::Rigid2& a, const grid::Rigid2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) + 3.0 * std::abs(grid::normalizeAngle(a.yaw - b.yaw));
}

TEST(Following, FollowsAMapThatGrowsAndDrifts) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene(seed);
    grid::Rigid2 truth{test::randomReal(scene.random, -3.0, 3.0), test::randomReal(scene.random, -3.0, 3.0),
                       test::randomReal(scene.random, -3.0, 3.0)};
    grid::Rigid2 known = truth;
    for (int k = 0; k < 12; ++k) {
      const grid::OccupancyGrid session =
          test::cutSession(scene.building, {6.0 + 0.5 * k, 6.0}, 6.0 + 0.3 * k, truth, kResolution);

      const SearchResult result = scene.follow(session, known);

      ASSERT_TRUE(result.found) << "map " << k;
      EXPECT_LT(apart(result.T_reference_session, truth), 0.5 * kResolution) << "map " << k;
      known = result.T_reference_session;
      truth = {truth.x + test::randomReal(scene.random, -0.15, 0.15),
               truth.y + test::randomReal(scene.random, -0.15, 0.15),
               truth.yaw + test::randomReal(scene.random, -0.01, 0.01)};
    }
  }
}

TEST(Following, AgreesWithTheExactSearchThatFindsThePlaceNearby) {
  const MapMatcher matcher;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene(seed);
    const double yaw = seed == 0 ? 0.0 : test::randomReal(scene.random, -3.0, 3.0);  // 0: the first of all rotations
    const grid::Rigid2 truth{1.0, -2.0, yaw};
    const grid::OccupancyGrid session = test::cutSession(scene.building, {9.0, 6.0}, 6.0, truth, kResolution);
    const SearchResult exact = matcher.match(scene.reference, session);
    const grid::Rigid2 nearby{truth.x + test::randomReal(scene.random, -0.2, 0.2),
                              truth.y + test::randomReal(scene.random, -0.2, 0.2), truth.yaw - 0.01};

    const SearchResult followed = scene.follow(session, nearby);

    ASSERT_TRUE(exact.certified && followed.found);
    EXPECT_LE(followed.hit_cells, exact.hit_cells);
    EXPECT_GE(followed.hit_cells, exact.hit_cells - 2) << "a top beside the highest one";
    EXPECT_EQ(followed.total_cells, exact.total_cells);
    EXPECT_EQ(followed.session_centre, exact.session_centre);
    EXPECT_LT(apart(followed.T_reference_session, exact.T_reference_session), 1e-3);
    EXPECT_TRUE(followed.covariance.isApprox(exact.covariance, 1e-2));
  }
}

TEST(Following, SaysWhatItFoundAndThatNothingIsProven) {
  Scene scene(1);
  const grid::Rigid2 truth{1.0, -2.0, 0.4};
  const grid::OccupancyGrid session = test::cutSession(scene.building, {9.0, 6.0}, 6.0, truth, kResolution);
  Demand demand;
  demand.worth = [](const Place& place) { return 0.5 * place.hit_ratio; };

  const SearchResult result = scene.follow(session, truth, demand);

  ASSERT_EQ(result.places.size(), 1U);
  EXPECT_EQ(result.places.front().worth, 0.5 * result.hit_ratio);
  EXPECT_EQ(result.places.front().covariance, result.covariance);
  EXPECT_EQ(result.ending, SearchEnding::kSearched);
  EXPECT_FALSE(result.certified);
  EXPECT_FALSE(result.runner_up_proven);
  EXPECT_EQ(result.elsewhere_bound, 1.0);
  ASSERT_EQ(result.stages.size(), 1U);
  EXPECT_EQ(result.stages.front().name, "follow");
  EXPECT_TRUE(result.stages.front().answered);
}

TEST(Following, FindsNothingInTheWrongPlace) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene(seed);
    const grid::Rigid2 truth{1.0, -2.0, 0.4};
    const grid::OccupancyGrid session = test::cutSession(scene.building, {9.0, 6.0}, 6.0, truth, kResolution);

    const SearchResult result = scene.follow(session, {truth.x + 4.0, truth.y, truth.yaw + 0.7});

    EXPECT_FALSE(result.found);
    EXPECT_TRUE(result.places.empty());
    EXPECT_EQ(result.ending, SearchEnding::kSearched);
    EXPECT_LT(result.stages.front().ratio, Demand{}.min_hit_ratio);
  }
}

TEST(Following, FindsNothingFarOutsideTheMap) {
  Scene scene(1);
  const grid::OccupancyGrid session = test::cutSession(scene.building, {9.0, 6.0}, 6.0, {}, kResolution);

  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (const grid::Rigid2& T_reference_session :
       {grid::Rigid2{1e6, -1e6, 100.0}, {1e300, 0.0, 1e300}, {not_a_number, 0.0, 0.0}, {0.0, 0.0, not_a_number}}) {
    const SearchResult result = scene.follow(session, T_reference_session);

    EXPECT_FALSE(result.found);
    EXPECT_EQ(result.stages.front().matched_cells, 0);
  }
}

TEST(Following, EndsWhenItIsStopped) {
  Scene scene(1);
  const grid::OccupancyGrid session = test::cutSession(scene.building, {9.0, 6.0}, 6.0, {}, kResolution);
  scene.reference.at(kResolution);
  work::StopToken stop;
  stop.requestStop();

  const SearchResult result = MapMatcher().follow(scene.reference, session, {}, {}, stop);

  EXPECT_FALSE(result.found);
  EXPECT_EQ(result.ending, SearchEnding::kStopped);
}

TEST(Following, NeedsEnoughCellsAndAnExactReference) {
  Scene scene(1);
  grid::OccupancyGrid empty(scene.building.geometry());
  SearchOptions two_stage;
  two_stage.search = "two_stage";

  EXPECT_EQ(scene.follow(empty, {}).ending, SearchEnding::kTooFewSessionCells);
  EXPECT_THROW(MapMatcher(two_stage).follow(scene.reference, empty, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace map_matcher::search
