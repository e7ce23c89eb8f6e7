// What the search says of places, at the facade. The seeds are fixed and named in every failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "map_matcher/search/map_matcher.hpp"
#include "support/cut.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

constexpr double kResolution = 0.05;

/// Three copies of a building in a row, of which the second and third miss some walls; a part of the first is seen.
struct ThreeBuildings {
  explicit ThreeBuildings(std::uint32_t seed)
      : random(seed), building(test::randomBuilding(random, 10.0, 8.0, kResolution)), reference(building) {
    grid::GridGeometry geometry = building.geometry();
    geometry.width = 3 * building.width();
    reference = grid::OccupancyGrid(geometry);
    for (int copy = 0; copy < 3; ++copy) {
      for (int y = 0; y < building.height(); ++y) {
        for (int x = 0; x < building.width(); ++x) {
          const bool missing = test::randomInt(random, 0, 99) < 10 * copy;
          reference.at(copy * building.width() + x, y) = missing ? grid::kFree : building.at(x, y);
        }
      }
    }
    session.push_back(test::cutSession(building, {5.0, 4.0}, 6.0, truth, kResolution));
  }

  SearchResult match(const Demand& demand, const SearchOptions& options = {}) const {
    return MapMatcher(options).match(Reference(reference, options), session.front(), demand);
  }

  std::mt19937 random;
  grid::OccupancyGrid building;
  grid::OccupancyGrid reference;
  std::vector<grid::OccupancyGrid> session;
  grid::Rigid2 truth{2.0, -1.0, 0.8};
};

double apart(const grid::Rigid2& a, const grid::Rigid2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(Places, AreTheBestOneAndTheBestOnesElsewhere) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ThreeBuildings buildings(seed);
    SearchOptions options;
    options.hit_tolerance = 0.0;  // so that what is missing counts
    Demand demand;
    demand.margin = 0.4;
    demand.most_places = 3;

    const SearchResult result = buildings.match(demand, options);

    ASSERT_EQ(result.places.size(), 3U);
    EXPECT_TRUE(result.certified);
    EXPECT_EQ(result.ending, SearchEnding::kSearched);
    const Place& best = result.places.front();
    EXPECT_EQ(best.T_reference_session.x, result.T_reference_session.x);
    EXPECT_EQ(best.searched.x, result.searched->x);
    EXPECT_EQ(best.covariance, result.covariance);
    EXPECT_EQ(best.hit_cells, result.hit_cells);
    EXPECT_EQ(best.matched_cells, result.matched_cells);
    EXPECT_EQ(result.places[1].hit_ratio, result.runner_up->ratio);
    for (int k = 0; k < 3; ++k) {
      const Place& place = result.places[static_cast<std::size_t>(k)];
      const grid::Rigid2 there{buildings.truth.x + 10.0 * k, buildings.truth.y, buildings.truth.yaw};
      EXPECT_LT(apart(place.T_reference_session, there), 0.1) << "place " << k;
      EXPECT_LT(apart(place.T_reference_session, place.searched), 0.1) << "place " << k;
      EXPECT_EQ(place.worth, place.hit_ratio);
      EXPECT_GT(place.covariance(0, 0), 0.0);
    }
    EXPECT_LE(result.elsewhere_bound, result.places.back().hit_ratio);
  }
}

TEST(Places, AreThoseOfAMatchFromAGlance) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ThreeBuildings buildings(seed);
    const MapMatcher matcher;
    const Reference reference(buildings.reference, {});
    const grid::OccupancyGrid& session = buildings.session.front();
    Demand easily;
    easily.min_hit_ratio = 0.8;

    const SearchResult whole = matcher.match(reference, session);
    const SearchResult glance = matcher.glance(reference, session, easily, {}, work::Deadline(60.0));
    const SearchResult from_there = matcher.matchFrom(glance, reference, session, {}, {}, work::Deadline(60.0));

    EXPECT_TRUE(glance.found);
    EXPECT_FALSE(glance.certified);
    EXPECT_TRUE(from_there.certified);
    EXPECT_EQ(from_there.hit_cells, whole.hit_cells);
    EXPECT_EQ(from_there.margin, whole.margin);
    ASSERT_EQ(from_there.places.size(), whole.places.size());
  }
}

TEST(Places, AreTheSameWhereverTheSearchBegins) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ThreeBuildings buildings(seed);
    SearchOptions options;
    options.threads = 1 + static_cast<int>(seed % 2);
    options.hit_tolerance = seed % 4 < 2 ? 0.0 : options.hit_tolerance;
    Demand demand;
    demand.min_hit_ratio = 0.3;
    demand.margin = 0.3;
    if (seed % 3 == 0) {  // the evidence speaks against the copies
      demand.worth = [](const Place& place) {
        return place.hit_ratio - (place.T_reference_session.x > 7.0 ? 0.3 : 0.0);
      };
    }
    Demand with_starts = demand;
    const grid::Rigid2& truth = buildings.truth;
    with_starts.starts = {{truth.x + 10.0, truth.y, truth.yaw}};
    if (seed % 2 == 0) {
      with_starts.starts.push_back({truth.x + 0.07, truth.y - 0.05, truth.yaw + 0.01});
      with_starts.starts.push_back({1e12, -1e12, 100.0});
    }

    const SearchResult plain = buildings.match(demand, options);
    const SearchResult begun = buildings.match(with_starts, options);

    EXPECT_TRUE(begun.certified);
    EXPECT_EQ(begun.hit_cells, plain.hit_cells);
    EXPECT_EQ(apart(begun.T_reference_session, plain.T_reference_session), 0.0);
    EXPECT_EQ(begun.upper_bound, plain.upper_bound);
    EXPECT_EQ(begun.margin, plain.margin);
    EXPECT_EQ(begun.elsewhere_bound, plain.elsewhere_bound);
    ASSERT_EQ(begun.places.size(), plain.places.size());
    for (std::size_t k = 0; k < plain.places.size(); ++k) {
      EXPECT_EQ(apart(begun.places[k].T_reference_session, plain.places[k].T_reference_session), 0.0) << "place " << k;
    }
  }
}

TEST(MapMatcher, KnowsTheBestOfItsStartsWhateverTimeIsLeft) {
  const ThreeBuildings buildings(6);
  const MapMatcher matcher;
  const Reference reference(buildings.reference, {});
  const grid::OccupancyGrid& session = buildings.session.front();
  Demand demand;
  demand.starts = {{buildings.truth.x + 0.05, buildings.truth.y, buildings.truth.yaw}};
  const SearchResult whole = matcher.match(reference, session, demand, {}, work::Deadline());
  SearchResult nothing;  // of the two stages

  bool reached = true;
  for (long look = 2; reached; ++look) {
    const test::Cut cut(look);
    const SearchResult result = matcher.matchFrom(nothing, reference, session, demand, {}, cut.deadline());
    reached = cut.reached();
    if (look > 30) {  // it has climbed there
      ASSERT_TRUE(result.found) << "look " << look;
      EXPECT_EQ(result.hit_cells, whole.hit_cells) << "look " << look;
    }
    EXPECT_GE(result.upper_bound, whole.hit_ratio) << "look " << look;
  }
}

TEST(Places, AreSoughtUntilNoOtherCanBeWorthAsMuch) {
  const ThreeBuildings buildings(1);
  SearchOptions options;
  options.hit_tolerance = 0.0;
  const std::thread::id here = std::this_thread::get_id();
  std::vector<double> asked;
  Demand demand;
  demand.min_hit_ratio = 0.3;
  demand.margin = 0.02;
  demand.worth = [&](const Place& place) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    asked.push_back(place.hit_ratio);
    return asked.size() == 1 ? 0.2 : asked.size() == 2 ? 0.6 : place.hit_ratio;  // the third one is the right one
  };

  const SearchResult result = buildings.match(demand, options);

  ASSERT_GE(result.places.size(), 3U);
  EXPECT_EQ(asked.size(), result.places.size());
  EXPECT_FALSE(result.runner_up) << "no place elsewhere has as many hits, less the margin";
  EXPECT_TRUE(result.runner_up_proven);
  EXPECT_EQ(result.places[0].worth, 0.2);
  EXPECT_EQ(result.places[1].worth, 0.6);
  double largest = 0.0;
  for (const Place& place : result.places) {
    largest = std::max(largest, place.worth);
  }
  EXPECT_LE(result.elsewhere_bound, largest - demand.margin + 1e-3);
}

TEST(Places, AreFewerThanTwoWhereNoRunnerUpIsWanted) {
  const ThreeBuildings buildings(2);
  Demand demand;
  demand.margin = 0.4;
  demand.most_places = 1;

  const SearchResult result = buildings.match(demand);

  EXPECT_EQ(result.places.size(), 1U);
  EXPECT_TRUE(result.certified);
  EXPECT_EQ(result.ending, SearchEnding::kSearched);
  EXPECT_FALSE(result.runner_up_proven);
  EXPECT_EQ(result.elsewhere_bound, result.places.front().hit_ratio);
}

TEST(Places, AreNoneWhereNothingHasAsManyHitsAsDemanded) {
  const ThreeBuildings buildings(3);
  std::mt19937 random(100);
  const grid::OccupancyGrid other = test::randomBuilding(random, 10.0, 8.0, kResolution);
  const SearchOptions options;

  const SearchResult result =
      MapMatcher(options).match(Reference(other, options), buildings.session.front(), Demand{0.9, 0.1});

  EXPECT_TRUE(result.certified);
  EXPECT_TRUE(result.places.empty());
  EXPECT_LT(result.elsewhere_bound, 0.9);
}

TEST(MapMatcher, BeginsTheExactSearchWithWhatTheTwoStagesFindInACrowd) {
  ThreeBuildings buildings(4);
  grid::OccupancyGrid& session = buildings.session.front();
  for (int k = 0; k < 90; ++k) {  // people who stand
    const int x = test::randomInt(buildings.random, 0, session.width() - 6);
    const int y = test::randomInt(buildings.random, 0, session.height() - 6);
    for (int cell = 0; cell < 25; ++cell) {
      session.at(x + cell % 5, y + cell / 5) = grid::kOccupied;
    }
  }
  Demand demand;
  demand.min_hit_ratio = 0.2;

  const SearchResult result = buildings.match(demand);

  ASSERT_TRUE(stageOf(result, "coarse"));
  EXPECT_LT(stageOf(result, "coarse")->ratio, SearchOptions{}.coarse.acceptance_ratio);
  EXPECT_TRUE(stageOf(result, "coarse")->answered);
  EXPECT_TRUE(result.certified);
  EXPECT_FALSE(result.replaced);
}

}  // namespace
}  // namespace map_matcher::search
