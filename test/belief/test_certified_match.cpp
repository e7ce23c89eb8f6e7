#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <random>
#include <thread>

#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/search/exact/certification.hpp"
#include "map_matcher/search/two_stage/two_stage_search.hpp"
#include "support/matcher.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kResolution = 0.05;

/// A building, a square of it as a session map, and where that lies.
struct Scene {
  explicit Scene(std::uint32_t seed) : random(seed), reference(test::randomBuilding(random, 24.0, 12.0, kResolution)) {
    session.push_back(test::cutSession(reference, {9.0, 6.0}, 7.0, truth, kResolution));
  }

  Answer match(const MatchOptions& options = {}, const search::Constraints& constraints = {},
               const Circumstances& circumstances = {}) const {
    const test::Matcher matcher(reference, options);
    return matcher.match(session[0], constraints, {}, circumstances);
  }

  double error(const grid::Rigid2& T_reference_session) const {
    const grid::Rigid2 error = truth.inverse() * T_reference_session;
    return std::hypot(error.x, error.y) + 3.5 * std::abs(error.yaw);
  }

  std::mt19937 random;
  grid::OccupancyGrid reference;
  std::vector<grid::OccupancyGrid> session;
  grid::Rigid2 truth{2.0, -1.0, 0.8};
};

/// Two copies of a building side by side, the second shifted by `distance`.
grid::OccupancyGrid twice(const grid::OccupancyGrid& building, double distance) {
  grid::GridGeometry geometry = building.geometry();
  const int shift = static_cast<int>(std::lround(distance / geometry.resolution));
  geometry.width += shift;
  grid::OccupancyGrid grid(geometry);
  for (int y = 0; y < building.height(); ++y) {
    for (int x = 0; x < building.width(); ++x) {
      grid.at(x, y) = std::max(grid.at(x, y), building.at(x, y));
      grid.at(x + shift, y) = std::max(grid.at(x + shift, y), building.at(x, y));
    }
  }
  return grid;
}

TEST(Certification, ProvesTheRightPlaceAndHowFarAheadOfAllOthersItIs) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene(seed);

    const Answer result = scene.match();

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_TRUE(result.search.certified);
    EXPECT_FALSE(result.search.replaced);
    EXPECT_LT(scene.error(result.search.T_reference_session), 0.15);
    EXPECT_GE(result.search.hit_ratio, result.search.ratio);
    EXPECT_DOUBLE_EQ(result.search.upper_bound, result.search.hit_ratio);
    EXPECT_GE(result.search.margin, BeliefOptions{}.min_margin);
    EXPECT_GT(result.search.covariance(0, 0), 0.0);
    EXPECT_LT(result.search.covariance(0, 0), kResolution * kResolution);
    EXPECT_LT(result.search.covariance(2, 2), 0.01 * 0.01);
  }
}

TEST(Certification, OfTwoEqualPlacesAcceptsNeitherAndNamesBoth) {
  Scene scene(1);
  scene.reference = twice(scene.reference, 30.0);

  const Answer result = scene.match();

  EXPECT_EQ(result.status, MatchStatus::kAmbiguous);
  EXPECT_TRUE(result.search.certified);
  ASSERT_TRUE(result.search.runner_up);
  EXPECT_NEAR(std::abs(result.search.T_reference_session.x - result.search.runner_up->T_reference_session.x), 30.0,
              0.2);
  EXPECT_NEAR(result.search.runner_up->ratio, result.search.hit_ratio, 1e-9);
  EXPECT_NEAR(result.search.margin, 0.0, 1e-9);
  EXPECT_NE(result.reason.find("min_margin = 0.1"), std::string::npos) << result.reason;
  EXPECT_NE(result.reason.find("elsewhere"), std::string::npos) << result.reason;
}

TEST(Certification, AcceptsOneOfTwoEqualPlacesWhenAPriorExcludesTheOther) {
  Scene scene(1);
  scene.reference = twice(scene.reference, 30.0);
  search::Constraints prior;
  prior.window = search::WindowPrior{scene.truth.translation(), {5.0, 5.0}};

  const Answer result = scene.match({}, prior);

  ASSERT_TRUE(result.matched()) << result.reason;
  EXPECT_LT(scene.error(result.search.T_reference_session), 0.15);
}

TEST(Certification, FollowsTheAlignmentOfAnEarlierMapWithoutAMargin) {
  Scene scene(1);
  scene.reference = twice(scene.reference, 30.0);
  const Answer ambiguous = scene.match();
  Circumstances agreeing;  // with the one of the two equal places that comes first
  agreeing.alignment = grid::Rigid2{0.3, -0.2, 0.02} * ambiguous.search.T_reference_session;
  Circumstances contradicting;
  contradicting.alignment = grid::Rigid2{5.0, 0.0, 0.0} * ambiguous.search.T_reference_session;
  MatchOptions strict;
  strict.belief.follow_alignment = false;

  const Answer followed = scene.match({}, {}, agreeing);

  EXPECT_EQ(ambiguous.status, MatchStatus::kAmbiguous);
  ASSERT_TRUE(followed.matched()) << followed.reason;
  EXPECT_NE(followed.reason.find("the place of an earlier session map"), std::string::npos) << followed.reason;
  EXPECT_TRUE(followed.search.searched);
  EXPECT_EQ(scene.match({}, {}, contradicting).status, MatchStatus::kAmbiguous);
  EXPECT_EQ(scene.match(strict, {}, agreeing).status, MatchStatus::kAmbiguous);
}

TEST(Certification, GivesUpAnEarlierPlaceOnlyForOneThatIsFoundTwice) {
  const Scene scene(1);
  Circumstances prior;
  prior.alignment = grid::Rigid2{5.0, 0.0, 0.0} * scene.match().search.T_reference_session;

  const Answer first = scene.match({}, {}, prior);
  prior.contender = first.search.T_reference_session;
  const Answer second = scene.match({}, {}, prior);
  prior.contender = grid::Rigid2{0.0, 5.0, 0.0} * first.search.T_reference_session;
  const Answer unlike_the_first = scene.match({}, {}, prior);

  EXPECT_EQ(first.status, MatchStatus::kUnconfirmed);
  EXPECT_LT(scene.error(first.search.T_reference_session), 0.15);
  EXPECT_NE(first.reason.find("matched at another place"), std::string::npos) << first.reason;
  EXPECT_TRUE(second.matched()) << second.reason;
  EXPECT_EQ(unlike_the_first.status, MatchStatus::kUnconfirmed);
}

TEST(Certification, ReplacesAWrongAnswer) {
  const Scene scene(2);
  const MatchOptions options;
  const search::SearchReference reference(scene.reference, kResolution, options.search);
  const search::SearchSession session = search::searchSession(scene.session[0], reference.resolution(), options.search);
  search::SearchResult wrong = search::twoStageSearch(reference, session, options.search, {}, work::Deadline());
  wrong.T_reference_session = grid::Rigid2{3.0, 1.0, 0.0} * wrong.T_reference_session;

  const Answer result = judge(
      {search::certify(wrong, reference, session, options.search, demandOf(options), {}, work::Deadline())}, options);

  ASSERT_TRUE(result.matched()) << result.reason;
  EXPECT_TRUE(result.search.replaced);
  EXPECT_LT(scene.error(result.search.T_reference_session), 0.15);
  EXPECT_NE(result.reason.find("a better place than the search began with"), std::string::npos) << result.reason;
}

TEST(Certification, FindsThePlaceWhenTheTwoStagesFindNone) {
  const Scene scene(3);
  const MatchOptions options;
  const search::SearchReference reference(scene.reference, kResolution, options.search);
  const search::SearchSession session = search::searchSession(scene.session[0], reference.resolution(), options.search);
  const search::SearchResult nothing;

  const Answer result = judge(
      {search::certify(nothing, reference, session, options.search, demandOf(options), {}, work::Deadline())}, options);

  ASSERT_TRUE(result.matched()) << result.reason;
  EXPECT_LT(scene.error(result.search.T_reference_session), 0.15);
}

TEST(Certification, AStrangerIsProvenToFitNowhere) {
  const Scene scene(4);
  Scene other(5);
  other.reference = scene.reference;
  MatchOptions options;
  options.belief.min_hit_ratio = 0.6;

  const Answer result = other.match(options);

  EXPECT_EQ(result.status, MatchStatus::kBelowAcceptanceRatio) << result.reason;
  EXPECT_TRUE(result.search.certified);
  EXPECT_FALSE(result.search.runner_up);
  EXPECT_EQ(result.search.margin, 0.0);
  EXPECT_LT(result.search.upper_bound, 0.6);
  EXPECT_FALSE(other.match().matched()) << "nor is it believed at the best of all places";
}

TEST(Certification, WithoutTimeIsNoMatchAndSaysHowMuchBetterAnotherMayBe) {
  const Scene scene(6);
  MatchOptions options;
  options.search.exact_deadline = 0.0;

  const Answer result = scene.match(options);

  EXPECT_EQ(result.status, MatchStatus::kNotCertified);
  EXPECT_FALSE(result.search.certified);
  EXPECT_GE(result.search.upper_bound, result.search.hit_ratio);
  EXPECT_NE(result.reason.find("exact_deadline = 0 s"), std::string::npos) << result.reason;
}

TEST(Certification, OfAMillionCellsAnswersWithinItsDeadline) {
  grid::OccupancyGrid noise({kResolution, 3000, 3000, {}});
  std::mt19937 random(1);
  for (int k = 0; k < 1100000; ++k) {
    noise.at(test::randomInt(random, 0, 2999), test::randomInt(random, 0, 2999)) = 100;
  }
  const Scene scene(7);
  MatchOptions options;
  options.search.exact_deadline = 0.5;
  const test::Matcher matcher(scene.reference, options);

  const Answer result = matcher.match(noise);

  EXPECT_EQ(result.status, MatchStatus::kNotCertified) << result.reason;
  EXPECT_EQ(result.search.upper_bound, 1.0);
  EXPECT_LT(result.search.search_time, 5.0);  // half a second, and reading a million cells on a busy machine
}

TEST(Certification, GivesTheSameAnswerWithAnyNumberOfThreads) {
  const Scene scene(7);
  MatchOptions options;
  options.belief.min_margin = 0.7;  // so that there is a runner-up
  const Answer alone = scene.match(options);
  ASSERT_TRUE(alone.search.runner_up);
  for (const int threads : {0, 2, 3}) {
    options.search.threads = threads;

    const Answer result = scene.match(options);

    EXPECT_EQ(result.search.T_reference_session.x, alone.search.T_reference_session.x);
    EXPECT_EQ(result.search.T_reference_session.yaw, alone.search.T_reference_session.yaw);
    EXPECT_EQ(result.search.hit_cells, alone.search.hit_cells);
    ASSERT_TRUE(result.search.runner_up);
    EXPECT_EQ(result.search.runner_up->T_reference_session.x, alone.search.runner_up->T_reference_session.x);
    EXPECT_EQ(result.search.margin, alone.search.margin);
  }
}

TEST(Certification, WithoutExactSearchTheTwoStagesAnswerStands) {
  const Scene scene(8);
  MatchOptions options;
  options.search.search = "two_stage";

  const Answer result = scene.match(options);

  ASSERT_TRUE(result.matched());
  EXPECT_FALSE(result.search.certified);
  EXPECT_EQ(result.search.stages.size(), 2U);
  EXPECT_EQ(result.search.hit_cells, 0);
}

TEST(Certification, HeadingPriorAsNarrowAsAStepStillHasARotation) {
  const Scene scene(9);
  search::Constraints prior;
  prior.heading = search::HeadingPrior{scene.truth.yaw, 1e-6};

  const Answer result = scene.match({}, prior);

  ASSERT_EQ(result.search.stages.back().name, "exact");
  EXPECT_EQ(result.search.stages.back().rotations, 1);
}

TEST(Certification, HeadingPriorMayBeAnyNumberOfTurnsOff) {
  const Scene scene(9);
  for (const double turns : {16e6, -16e6, 1.0}) {
    SCOPED_TRACE(std::to_string(turns) + " turns");
    search::Constraints prior;
    prior.heading = search::HeadingPrior{scene.truth.yaw + 2.0 * M_PI * turns, 0.1};

    const Answer result = scene.match({}, prior);

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_LT(scene.error(result.search.T_reference_session), 0.15);
  }
}

/// Walls everywhere, without any order: no bound tells one place from another.
grid::OccupancyGrid noise(std::uint32_t seed, int size) {
  std::mt19937 random(seed);
  grid::OccupancyGrid grid({kResolution, size, size, {}});
  for (const grid::Cell& cell : test::randomCells(random, size, size, size * size / 12)) {
    grid.at(cell.x, cell.y) = grid::kOccupied;
  }
  return grid;
}

class Noise : public testing::Test {
 protected:
  Noise() {
    options_.search.coarse.acceptance_ratio = options_.belief.min_hit_ratio = 0.2;
    options_.search.exact_deadline = 3600.0;
    options_.search.hit_tolerance = 0.0;
  }

  double secondsOf(const std::function<void()>& work) const {
    const auto before = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  }

  MatchOptions options_;
  const grid::OccupancyGrid reference_ = noise(1, 500);
  const grid::OccupancyGrid session_ = noise(2, 150);
};

TEST_F(Noise, EndsWithin50MillisecondsOfAStop) {
  const test::Matcher matcher(reference_, options_);
  work::StopToken stop;
  Answer result;
  std::thread searching([&] { result = matcher.match(session_, {}, stop); });
  std::this_thread::sleep_for(std::chrono::milliseconds(500));

  const double taken = secondsOf([&] {
    stop.requestStop();
    searching.join();
  });

  EXPECT_EQ(result.status, MatchStatus::kStopped) << result.reason;
  EXPECT_LT(taken, 0.25);  // 50 ms, on a machine that does other things as well
}

TEST_F(Noise, EndsAtItsDeadlineWithTheGap) {
  options_.search.exact_deadline = 0.1;
  const test::Matcher matcher(reference_, options_);

  const Answer result = matcher.match(session_);

  EXPECT_EQ(result.status, MatchStatus::kNotCertified) << result.reason;
  EXPECT_LT(result.search.search_time, 0.4);
  EXPECT_GT(result.search.upper_bound, options_.search.coarse.acceptance_ratio);
  EXPECT_LE(result.search.upper_bound, 1.0);
}

}  // namespace
}  // namespace map_matcher::belief
