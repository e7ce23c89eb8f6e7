#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "support/ascii_map.hpp"
#include "support/cut.hpp"
#include "support/matcher.hpp"
#include "support/no_threads.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kResolution = 0.05;

/// Largest displacement of a point of the session, up to `reach` [m] from `centre` in the reference.
double largestError(const grid::Rigid2& estimate, const grid::Rigid2& truth, const Eigen::Vector2d& centre,
                    double reach) {
  double error = 0.0;
  for (const auto& corner : {Eigen::Vector2d(-reach, -reach), Eigen::Vector2d(reach, -reach),
                             Eigen::Vector2d(-reach, reach), Eigen::Vector2d(reach, reach)}) {
    const Eigen::Vector2d p_session = truth.inverse() * Eigen::Vector2d(centre + corner);
    error = std::max(error, (estimate * p_session - truth * p_session).norm());
  }
  return error;
}

/// A building, a square of it as a session map, and where that lies.
struct Scene {
  explicit Scene(std::uint32_t seed, const grid::Rigid2& T_map_grid = {}, double session_resolution = kResolution)
      : random(seed), reference(test::randomBuilding(random, 30.0, 14.0, kResolution, T_map_grid)) {
    centre = T_map_grid * Eigen::Vector2d(test::randomReal(random, 6.0, 24.0), test::randomReal(random, 5.0, 9.0));
    truth = {test::randomReal(random, -9.0, 9.0), test::randomReal(random, -9.0, 9.0),
             test::randomReal(random, -3.1, 3.1)};
    session =
        std::make_unique<grid::OccupancyGrid>(test::cutSession(reference, centre, 8.0, truth, session_resolution));
  }

  std::mt19937 random;
  grid::OccupancyGrid reference;
  Eigen::Vector2d centre{0.0, 0.0};
  grid::Rigid2 truth;
  std::unique_ptr<grid::OccupancyGrid> session;
};

Answer match(const Scene& scene, const MatchOptions& options = {}, const search::Constraints& prior = {}) {
  const test::Matcher matcher(scene.reference, options);
  return matcher.match(*scene.session, prior);
}

TEST(SingleMatch, FindsASessionOfASyntheticBuildingWithinOneCellAndOneAngularStep) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene(seed);

    const Answer result = match(scene);

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_TRUE(result.search.refined);
    // One cell at the middle of the session; the angular step is that of the coarse stage, since with whole cells and
    // walls one cell thick the best score may lie two fine steps beside the truth.
    const double coarse_step = search::rotationStep(2.0, std::sqrt(2.0) * 8.0 / result.search.stages[0].resolution);
    const grid::Rigid2 error = scene.truth.inverse() * result.search.T_reference_session;
    EXPECT_LE(std::abs(error.yaw), coarse_step);
    EXPECT_LE((result.search.T_reference_session * (scene.truth.inverse() * scene.centre) - scene.centre).norm(),
              kResolution);
  }
}

TEST(SingleMatch, AnswerMovesWithTheOriginOfEitherMap) {
  const grid::Rigid2 moved{12.3, -4.5, 0.7};
  const Scene scene(5);
  grid::GridGeometry reference_geometry = scene.reference.geometry();
  reference_geometry.T_map_grid = moved * reference_geometry.T_map_grid;
  grid::GridGeometry session_geometry = scene.session->geometry();
  session_geometry.T_map_grid = moved * session_geometry.T_map_grid;
  const test::Matcher matcher(scene.reference);
  const test::Matcher in_moved({reference_geometry, scene.reference.values()});

  const grid::Rigid2 plain = matcher.match(*scene.session).search.T_reference_session;
  const grid::Rigid2 session_moved =
      matcher.match({session_geometry, scene.session->values()}).search.T_reference_session;
  const grid::Rigid2 reference_moved = in_moved.match(*scene.session).search.T_reference_session;

  EXPECT_LT(largestError(session_moved * moved, plain, scene.centre, 4.0), 1e-6);
  EXPECT_LT(largestError(moved.inverse() * reference_moved, plain, scene.centre, 4.0), 1e-6);
}

TEST(SingleMatch, FindsTheSamePlaceFromEveryHeading) {
  for (std::uint32_t seed = 30; seed < 34; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene(seed, {3.0, -2.0, 1.1});

    const Answer result = match(scene);

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_LT(largestError(result.search.T_reference_session, scene.truth, scene.centre, 4.0), 2.5 * kResolution);
  }
}

TEST(SingleMatch, TakesSessionMapsOfOtherResolutions) {
  for (const double resolution : {0.02, 0.025, 0.05, 0.07, 0.1}) {
    SCOPED_TRACE("session resolution " + std::to_string(resolution));
    const Scene scene(8, {}, resolution);

    const Answer result = match(scene);

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_LT(largestError(result.search.T_reference_session, scene.truth, scene.centre, 4.0), 0.15);
  }
}

TEST(SingleMatch, CellOffsetsMoveTheAnswerByThatShareOfACell) {
  const Scene scene(5);
  MatchOptions options;
  options.search.session_map_cell_offset = 0.5;
  options.search.reference_map_cell_offset = -0.5;

  const grid::Rigid2 plain = match(scene).search.T_reference_session;
  const grid::Rigid2 corrected = match(scene, options).search.T_reference_session;

  // A session map drawn half a cell too far along +x and +y: a true point lies half a cell below where it was drawn.
  const Eigen::Vector2d half_cell(0.5 * kResolution, 0.5 * kResolution);
  const Eigen::Vector2d p_drawn(1.0, 2.0);
  const Eigen::Vector2d p_true = p_drawn - half_cell;
  EXPECT_LT((corrected * p_true - (plain * p_drawn + half_cell)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(corrected.yaw, plain.yaw);
}

TEST(SingleMatch, SamplesReproduciblyAndStillFindsThePlace) {
  const Scene scene(11);
  MatchOptions options;
  options.search.hits_sample_threshold = 300;

  const Answer once = match(scene, options);
  const Answer again = match(scene, options);

  ASSERT_TRUE(once.matched()) << once.reason;
  EXPECT_EQ(once.search.total_cells, 300);
  EXPECT_EQ(once.search.T_reference_session.x, again.search.T_reference_session.x);
  EXPECT_EQ(once.search.matched_cells, again.search.matched_cells);
  EXPECT_LT(largestError(once.search.T_reference_session, scene.truth, scene.centre, 4.0), 0.2);
}

TEST(SingleMatch, HeadingPriorGivesTheSameAnswerAndOneThatExcludesTheTruthDoesNot) {
  const Scene scene(12);
  search::Constraints near_truth;
  near_truth.heading = search::HeadingPrior{scene.truth.yaw + 0.1, 0.3};
  search::Constraints ordering_only;
  ordering_only.heading = search::HeadingPrior{scene.truth.yaw, M_PI};
  search::Constraints opposite;
  opposite.heading = search::HeadingPrior{scene.truth.yaw + M_PI, 0.3};

  const Answer without = match(scene);
  const Answer with = match(scene, {}, near_truth);
  const Answer ordered = match(scene, {}, ordering_only);
  const Answer excluded = match(scene, {}, opposite);

  ASSERT_TRUE(without.matched() && with.matched() && ordered.matched());
  EXPECT_EQ(with.search.matched_cells, without.search.matched_cells);
  EXPECT_EQ(ordered.search.matched_cells, without.search.matched_cells);
  EXPECT_LT(with.search.stages[0].rotations, without.search.stages[0].rotations);
  EXPECT_TRUE(!excluded.matched() ||
              std::abs(grid::normalizeAngle(excluded.search.T_reference_session.yaw - scene.truth.yaw)) > 2.5);
}

TEST(SingleMatch, WindowPriorNarrowsTheSearchToItsBox) {
  const Scene scene(13, {3.0, -2.0, 0.4});
  search::Constraints around_truth;
  around_truth.window = search::WindowPrior{scene.truth.translation() + Eigen::Vector2d(0.4, -0.3), {1.0, 1.0}};
  search::Constraints elsewhere;
  elsewhere.window = search::WindowPrior{scene.truth.translation() + Eigen::Vector2d(8.0, 0.0), {1.0, 1.0}};

  const Answer without = match(scene);
  const Answer with = match(scene, {}, around_truth);
  const Answer other = match(scene, {}, elsewhere);

  ASSERT_TRUE(with.matched()) << with.reason;
  EXPECT_EQ(with.search.matched_cells, without.search.matched_cells);
  EXPECT_LT(with.search.stages[0].nodes_scored, without.search.stages[0].nodes_scored / 10);
  EXPECT_TRUE(!other.matched() ||
              (other.search.T_reference_session.translation() - scene.truth.translation()).norm() > 4.0);
}

TEST(SingleMatch, ReportsEachStageAndWhatItTook) {
  const Scene scene(14);

  const Answer result = match(scene);

  ASSERT_EQ(result.search.stages.size(), 3U);
  EXPECT_EQ(result.search.stages[0].name, "coarse");
  EXPECT_DOUBLE_EQ(result.search.stages[0].resolution, 0.2);
  EXPECT_EQ(result.search.stages[1].name, "fine");
  EXPECT_DOUBLE_EQ(result.search.stages[1].resolution, kResolution);
  EXPECT_EQ(result.search.stages[2].name, "exact");
  EXPECT_DOUBLE_EQ(result.search.stages[2].resolution, kResolution);
  EXPECT_EQ(result.search.hit_cells, result.search.stages[2].matched_cells);
  EXPECT_DOUBLE_EQ(result.search.ratio, static_cast<double>(result.search.matched_cells) / result.search.total_cells);
  for (const search::StageReport& stage : result.search.stages) {
    EXPECT_GT(stage.nodes_scored, 0);
    EXPECT_GT(stage.rotation_expansion_time, 0.0);
    EXPECT_LE(stage.initialization_time + stage.rotation_expansion_time + stage.depth_first_search_time,
              result.search.search_time);
  }
  EXPECT_GT(result.search.reference_time, 0.0);
}

TEST(SingleMatch, KeepsTheCoarseAnswerWhenTheFineStageHasNone) {
  const Scene scene(15);
  MatchOptions options;
  options.search.search = "two_stage";
  options.search.fine.acceptance_ratio = 1.0;  // no real session reaches it

  const Answer result = match(scene, options);

  ASSERT_TRUE(result.matched());
  EXPECT_FALSE(result.search.refined);
  EXPECT_FALSE(result.search.stages[1].answered);
  EXPECT_EQ(result.search.matched_cells, result.search.stages[0].matched_cells);
  EXPECT_NE(result.reason.find("coarse answer stands"), std::string::npos);
  EXPECT_LT(largestError(result.search.T_reference_session, scene.truth, scene.centre, 4.0), 0.6);
}

TEST(SingleMatch, SaysNoWhenNothingReachesTheAcceptanceRatio) {
  Scene scene(16);
  std::mt19937 random(99);
  const grid::OccupancyGrid stranger = test::randomBuilding(random, 9.0, 8.0, kResolution);
  MatchOptions options;
  options.belief.min_hit_ratio = 0.95;
  const test::Matcher matcher(scene.reference, options);

  const Answer result = matcher.match(stranger);

  EXPECT_EQ(result.status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_STREQ(toString(result.status), "below_acceptance_ratio");
  EXPECT_NE(result.reason.find("0.95"), std::string::npos);
}

TEST(SingleMatch, ReferenceWithoutWallsIsAReason) {
  const test::Matcher matcher(test::asciiMap({"..?", "???"}));

  EXPECT_EQ(matcher.match(test::asciiMap({"#"})).status, MatchStatus::kEmptyReference);
}

TEST(SingleMatch, TooFewSessionCellsAreAReasonWithTheNumbers) {
  const test::Matcher matcher(test::asciiMap({"####"}));

  for (const auto& session : {test::asciiMap({"??", "??"}), test::asciiMap({"..", ".#"})}) {
    const Answer result = matcher.match(session);

    EXPECT_EQ(result.status, MatchStatus::kTooFewSessionCells);
    EXPECT_NE(result.reason.find("min_session_cells = 100"), std::string::npos) << result.reason;
  }
}

TEST(SingleMatch, SessionTooLargeForItsArithmeticIsAReason) {
  MatchOptions options;
  options.search.min_session_cells = 1;
  const test::Matcher matcher(test::asciiMap({"####"}, 0.01), options);
  grid::GridGeometry geometry;
  geometry.resolution = 0.01;
  geometry.width = 40000;
  geometry.height = 1;
  grid::OccupancyGrid session(geometry);
  session.at(0, 0) = session.at(39999, 0) = grid::kOccupied;

  EXPECT_EQ(matcher.match(session).status, MatchStatus::kSessionTooLarge);
}

TEST(SingleMatch, SessionsOfOneCellOrOneSpotAreAnswered) {
  MatchOptions options;
  options.search.min_session_cells = 1;
  for (const char* search : {"two_stage", "exact"}) {
    options.search.search = search;
    const test::Matcher matcher(test::asciiMap({"#.#", "...", "###"}), options);
    const MatchStatus expected = options.search.search == "exact" ? MatchStatus::kAmbiguous : MatchStatus::kMatched;

    EXPECT_EQ(matcher.match(test::asciiMap({"#"})).status, expected);
    EXPECT_EQ(matcher.match(test::asciiMap({"...", ".#.", "..."}, 0.1)).status, expected);
  }
}

TEST(SingleMatch, SessionLargerThanTheReferenceIsAnswered) {
  std::mt19937 random(4);
  const grid::OccupancyGrid large = test::randomBuilding(random, 20.0, 12.0, kResolution);
  const grid::OccupancyGrid part = test::cutSession(large, {10.0, 6.0}, 16.0, {}, kResolution);
  const test::Matcher matcher(part);

  const Answer result = matcher.match(large);

  ASSERT_TRUE(result.matched()) << result.reason;
  EXPECT_LT(largestError(result.search.T_reference_session, {}, {10.0, 6.0}, 3.0), 0.15);
}

TEST(SingleMatch, StopsBeforeAndDuringASearch) {
  const Scene scene(17);
  MatchOptions options;
  options.search.coarse.acceptance_ratio = 0.0;  // nothing is pruned: minutes of work
  options.search.coarse_resolution = kResolution;
  const test::Matcher matcher(scene.reference, options);
  work::StopToken stopped_before;
  stopped_before.requestStop();
  EXPECT_EQ(matcher.match(*scene.session, {}, stopped_before).status, MatchStatus::kStopped);

  work::StopToken stop;
  Answer result;
  std::thread searching([&] { result = matcher.match(*scene.session, {}, stop); });
  stop.requestStop();
  searching.join();

  EXPECT_EQ(result.status, MatchStatus::kStopped);
}

TEST(SingleMatch, EndsTheTwoStagesAtTheDeadlineToo) {
  const Scene scene(17);
  MatchOptions options;
  options.search.search = "two_stage";
  options.search.exact_deadline = 0.0;

  const Answer result = match(scene, options);

  EXPECT_EQ(result.status, MatchStatus::kNotCertified);
  EXPECT_NE(result.reason.find("the time was over in the coarse stage"), std::string::npos) << result.reason;
}

TEST(SingleMatch, RejectsEveryOptionOutOfRangeByNameValueAndRange) {
  MatchOptions options;
  options.search.coarse.acceptance_ratio = 1.5;
  options.search.hits_sample_threshold = -3;
  options.search.coarse_resolution = std::nan("");
  options.search.hit_tolerance = std::nan("");
  options.search.threads = -1;
  options.search.search = "magic";
  options.belief.min_margin = -1.0;

  try {
    const search::Reference reference(test::asciiMap({"#"}), {});
    matchAlone({&reference}, test::asciiMap({"#"}), options);
    FAIL() << "expected std::invalid_argument";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("acceptance_ratio is 1.5, expected 0 to 1"), std::string::npos) << text;
    EXPECT_NE(text.find("hits_sample_threshold is -3"), std::string::npos) << text;
    EXPECT_NE(text.find("coarse_resolution is nan"), std::string::npos) << text;
    EXPECT_NE(text.find("hit_tolerance is nan"), std::string::npos) << text;
    EXPECT_NE(text.find("min_margin is -1"), std::string::npos) << text;
    EXPECT_NE(text.find("threads is -1"), std::string::npos) << text;
    EXPECT_NE(text.find("two_stage | exact"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace map_matcher::belief
