#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "support/ascii_map.hpp"
#include "support/cut.hpp"
#include "support/no_threads.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
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

MatchResult match(const Scene& scene, const MatchOptions& options = {}, const MatchPrior& prior = {}) {
  MapMatcher matcher(options);
  matcher.setReference(scene.reference);
  return matcher.match(*scene.session, prior);
}

TEST(MapMatcher, FindsASessionOfASyntheticBuildingWithinOneCellAndOneAngularStep) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene(seed);

    const MatchResult result = match(scene);

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_TRUE(result.refined);
    // One cell at the middle of the session; the angular step is that of the coarse stage, since with whole cells and
    // walls one cell thick the best score may lie two fine steps beside the truth.
    const double coarse_step = rotationStep(2.0, std::sqrt(2.0) * 8.0 / result.stages[0].resolution);
    const grid::Rigid2 error = scene.truth.inverse() * result.T_reference_session;
    EXPECT_LE(std::abs(error.yaw), coarse_step);
    EXPECT_LE((result.T_reference_session * (scene.truth.inverse() * scene.centre) - scene.centre).norm(), kResolution);
  }
}

TEST(MapMatcher, AnswerMovesWithTheOriginOfEitherMap) {
  const grid::Rigid2 moved{12.3, -4.5, 0.7};
  const Scene scene(5);
  grid::GridGeometry reference_geometry = scene.reference.geometry();
  reference_geometry.T_map_grid = moved * reference_geometry.T_map_grid;
  grid::GridGeometry session_geometry = scene.session->geometry();
  session_geometry.T_map_grid = moved * session_geometry.T_map_grid;
  MapMatcher matcher;

  matcher.setReference(scene.reference);
  const grid::Rigid2 plain = matcher.match(*scene.session).T_reference_session;
  const grid::Rigid2 session_moved = matcher.match({session_geometry, scene.session->values()}).T_reference_session;
  matcher.setReference({reference_geometry, scene.reference.values()});
  const grid::Rigid2 reference_moved = matcher.match(*scene.session).T_reference_session;

  EXPECT_LT(largestError(session_moved * moved, plain, scene.centre, 4.0), 1e-6);
  EXPECT_LT(largestError(moved.inverse() * reference_moved, plain, scene.centre, 4.0), 1e-6);
}

TEST(MapMatcher, FindsTheSamePlaceFromEveryHeading) {
  for (std::uint32_t seed = 30; seed < 34; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene(seed, {3.0, -2.0, 1.1});

    const MatchResult result = match(scene);

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_LT(largestError(result.T_reference_session, scene.truth, scene.centre, 4.0), 2.5 * kResolution);
  }
}

TEST(MapMatcher, TakesSessionMapsOfOtherResolutions) {
  for (const double resolution : {0.02, 0.025, 0.05, 0.07, 0.1}) {
    SCOPED_TRACE("session resolution " + std::to_string(resolution));
    const Scene scene(8, {}, resolution);

    const MatchResult result = match(scene);

    ASSERT_TRUE(result.matched()) << result.reason;
    EXPECT_LT(largestError(result.T_reference_session, scene.truth, scene.centre, 4.0), 0.15);
  }
}

TEST(MapMatcher, CellOffsetsMoveTheAnswerByThatShareOfACell) {
  const Scene scene(5);
  MatchOptions options;
  options.session_map_cell_offset = 0.5;
  options.reference_map_cell_offset = -0.5;

  const grid::Rigid2 plain = match(scene).T_reference_session;
  const grid::Rigid2 corrected = match(scene, options).T_reference_session;

  // A session map drawn half a cell too far along +x and +y: a true point lies half a cell below where it was drawn.
  const Eigen::Vector2d half_cell(0.5 * kResolution, 0.5 * kResolution);
  const Eigen::Vector2d p_drawn(1.0, 2.0);
  const Eigen::Vector2d p_true = p_drawn - half_cell;
  EXPECT_LT((corrected * p_true - (plain * p_drawn + half_cell)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(corrected.yaw, plain.yaw);
}

TEST(MapMatcher, SamplesReproduciblyAndStillFindsThePlace) {
  const Scene scene(11);
  MatchOptions options;
  options.hits_sample_threshold = 300;

  const MatchResult once = match(scene, options);
  const MatchResult again = match(scene, options);

  ASSERT_TRUE(once.matched()) << once.reason;
  EXPECT_EQ(once.total_cells, 300);
  EXPECT_EQ(once.T_reference_session.x, again.T_reference_session.x);
  EXPECT_EQ(once.matched_cells, again.matched_cells);
  EXPECT_LT(largestError(once.T_reference_session, scene.truth, scene.centre, 4.0), 0.2);
}

TEST(MapMatcher, HeadingPriorGivesTheSameAnswerAndOneThatExcludesTheTruthDoesNot) {
  const Scene scene(12);
  MatchPrior near_truth;
  near_truth.heading = HeadingPrior{scene.truth.yaw + 0.1, 0.3};
  MatchPrior ordering_only;
  ordering_only.heading = HeadingPrior{scene.truth.yaw, M_PI};
  MatchPrior opposite;
  opposite.heading = HeadingPrior{scene.truth.yaw + M_PI, 0.3};

  const MatchResult without = match(scene);
  const MatchResult with = match(scene, {}, near_truth);
  const MatchResult ordered = match(scene, {}, ordering_only);
  const MatchResult excluded = match(scene, {}, opposite);

  ASSERT_TRUE(without.matched() && with.matched() && ordered.matched());
  EXPECT_EQ(with.matched_cells, without.matched_cells);
  EXPECT_EQ(ordered.matched_cells, without.matched_cells);
  EXPECT_LT(with.stages[0].rotations, without.stages[0].rotations);
  EXPECT_TRUE(!excluded.matched() ||
              std::abs(grid::normalizeAngle(excluded.T_reference_session.yaw - scene.truth.yaw)) > 2.5);
}

TEST(MapMatcher, WindowPriorNarrowsTheSearchToItsBox) {
  const Scene scene(13, {3.0, -2.0, 0.4});
  MatchPrior around_truth;
  around_truth.window = WindowPrior{scene.truth.translation() + Eigen::Vector2d(0.4, -0.3), {1.0, 1.0}};
  MatchPrior elsewhere;
  elsewhere.window = WindowPrior{scene.truth.translation() + Eigen::Vector2d(8.0, 0.0), {1.0, 1.0}};

  const MatchResult without = match(scene);
  const MatchResult with = match(scene, {}, around_truth);
  const MatchResult other = match(scene, {}, elsewhere);

  ASSERT_TRUE(with.matched()) << with.reason;
  EXPECT_EQ(with.matched_cells, without.matched_cells);
  EXPECT_LT(with.stages[0].nodes_scored, without.stages[0].nodes_scored / 10);
  EXPECT_TRUE(!other.matched() || (other.T_reference_session.translation() - scene.truth.translation()).norm() > 4.0);
}

TEST(MapMatcher, ReportsEachStageAndWhatItTook) {
  const Scene scene(14);

  const MatchResult result = match(scene);

  ASSERT_EQ(result.stages.size(), 3U);
  EXPECT_EQ(result.stages[0].name, "coarse");
  EXPECT_DOUBLE_EQ(result.stages[0].resolution, 0.2);
  EXPECT_EQ(result.stages[1].name, "fine");
  EXPECT_DOUBLE_EQ(result.stages[1].resolution, kResolution);
  EXPECT_EQ(result.stages[2].name, "exact");
  EXPECT_DOUBLE_EQ(result.stages[2].resolution, kResolution);
  EXPECT_EQ(result.hit_cells, result.stages[2].matched_cells);
  EXPECT_DOUBLE_EQ(result.ratio, static_cast<double>(result.matched_cells) / result.total_cells);
  for (const StageReport& stage : result.stages) {
    EXPECT_GT(stage.nodes_scored, 0);
    EXPECT_GT(stage.rotation_expansion_time, 0.0);
    EXPECT_LE(stage.initialization_time + stage.rotation_expansion_time + stage.depth_first_search_time,
              result.search_time);
  }
  EXPECT_GT(result.reference_time, 0.0);
}

TEST(MapMatcher, KeepsTheCoarseAnswerWhenTheFineStageHasNone) {
  const Scene scene(15);
  MatchOptions options;
  options.search = "two_stage";
  options.fine.acceptance_ratio = 1.0;  // no real session reaches it

  const MatchResult result = match(scene, options);

  ASSERT_TRUE(result.matched());
  EXPECT_FALSE(result.refined);
  EXPECT_FALSE(result.stages[1].answered);
  EXPECT_EQ(result.matched_cells, result.stages[0].matched_cells);
  EXPECT_NE(result.reason.find("coarse answer stands"), std::string::npos);
  EXPECT_LT(largestError(result.T_reference_session, scene.truth, scene.centre, 4.0), 0.6);
}

TEST(MapMatcher, SaysNoWhenNothingReachesTheAcceptanceRatio) {
  Scene scene(16);
  std::mt19937 random(99);
  const grid::OccupancyGrid stranger = test::randomBuilding(random, 9.0, 8.0, kResolution);
  MatchOptions options;
  options.coarse.acceptance_ratio = 0.95;
  MapMatcher matcher(options);
  matcher.setReference(scene.reference);

  const MatchResult result = matcher.match(stranger);

  EXPECT_EQ(result.status, MatchStatus::kBelowAcceptanceRatio);
  EXPECT_STREQ(toString(result.status), "below_acceptance_ratio");
  EXPECT_NE(result.reason.find("0.95"), std::string::npos);
}

TEST(MapMatcher, WithoutReferenceSaysSo) {
  MapMatcher matcher;

  EXPECT_FALSE(matcher.hasReference());
  EXPECT_EQ(matcher.match(test::asciiMap({"#"})).status, MatchStatus::kNoReference);
}

TEST(MapMatcher, ReferenceWithoutWallsIsAReason) {
  MapMatcher matcher;
  matcher.setReference(test::asciiMap({"..?", "???"}));

  EXPECT_EQ(matcher.match(test::asciiMap({"#"})).status, MatchStatus::kEmptyReference);
}

TEST(MapMatcher, TooFewSessionCellsAreAReasonWithTheNumbers) {
  MapMatcher matcher;
  matcher.setReference(test::asciiMap({"####"}));

  for (const auto& session : {test::asciiMap({"??", "??"}), test::asciiMap({"..", ".#"})}) {
    const MatchResult result = matcher.match(session);

    EXPECT_EQ(result.status, MatchStatus::kTooFewSessionCells);
    EXPECT_NE(result.reason.find("min_session_cells = 100"), std::string::npos) << result.reason;
  }
}

TEST(MapMatcher, SessionTooLargeForItsArithmeticIsAReason) {
  MatchOptions options;
  options.min_session_cells = 1;
  MapMatcher matcher(options);
  matcher.setReference(test::asciiMap({"####"}, 0.01));
  grid::GridGeometry geometry;
  geometry.resolution = 0.01;
  geometry.width = 40000;
  geometry.height = 1;
  grid::OccupancyGrid session(geometry);
  session.at(0, 0) = session.at(39999, 0) = grid::kOccupied;

  EXPECT_EQ(matcher.match(session).status, MatchStatus::kSessionTooLarge);
}

TEST(MapMatcher, SessionsOfOneCellOrOneSpotAreAnswered) {
  MatchOptions options;
  options.min_session_cells = 1;
  for (const char* search : {"two_stage", "exact"}) {
    options.search = search;
    MapMatcher matcher(options);
    matcher.setReference(test::asciiMap({"#.#", "...", "###"}));
    const MatchStatus expected = options.search == "exact" ? MatchStatus::kAmbiguous : MatchStatus::kMatched;

    EXPECT_EQ(matcher.match(test::asciiMap({"#"})).status, expected);
    EXPECT_EQ(matcher.match(test::asciiMap({"...", ".#.", "..."}, 0.1)).status, expected);
  }
}

TEST(MapMatcher, SessionLargerThanTheReferenceIsAnswered) {
  std::mt19937 random(4);
  const grid::OccupancyGrid large = test::randomBuilding(random, 20.0, 12.0, kResolution);
  const grid::OccupancyGrid part = test::cutSession(large, {10.0, 6.0}, 7.0, {}, kResolution);
  MatchOptions options;
  options.coarse.acceptance_ratio = options.min_hit_ratio =
      0.09;  // of what the session holds, the reference has no more
  options.min_margin = 0.02;
  MapMatcher matcher(options);
  matcher.setReference(part);

  const MatchResult result = matcher.match(large);

  ASSERT_TRUE(result.matched()) << result.reason;
  EXPECT_LT(largestError(result.T_reference_session, {}, {10.0, 6.0}, 3.0), 0.15);
}

TEST(MapMatcher, StopsBeforeAndDuringASearch) {
  const Scene scene(17);
  MatchOptions options;
  options.coarse.acceptance_ratio = 0.0;  // nothing is pruned: minutes of work
  options.coarse_resolution = kResolution;
  MapMatcher matcher(options);
  matcher.setReference(scene.reference);
  work::StopToken stopped_before;
  stopped_before.requestStop();
  EXPECT_EQ(matcher.match(*scene.session, {}, stopped_before).status, MatchStatus::kStopped);

  work::StopToken stop;
  MatchResult result;
  std::thread searching([&] { result = matcher.match(*scene.session, {}, stop); });
  stop.requestStop();
  searching.join();

  EXPECT_EQ(result.status, MatchStatus::kStopped);
}

TEST(MapMatcher, GivesUpBuildingWhatACoarserSessionMapNeedsWhenItIsStopped) {
  const Scene fine(8);
  const Scene coarse(8, {}, 0.1);
  MapMatcher matcher;
  matcher.setReference(fine.reference);
  const MatchResult before = matcher.match(*fine.session);
  work::StopToken stop;
  stop.requestStop();

  const MatchResult stopped = matcher.match(*coarse.session, {}, stop);
  const MatchResult after = matcher.match(*fine.session);

  EXPECT_EQ(stopped.status, MatchStatus::kStopped);
  EXPECT_NE(stopped.reason.find("while the reference map was prepared"), std::string::npos) << stopped.reason;
  EXPECT_EQ(after.reference_time, before.reference_time);  // it was not built again
  EXPECT_EQ(after.T_reference_session.x, before.T_reference_session.x);
  EXPECT_TRUE(matcher.match(*coarse.session).matched());
}

TEST(MapMatcher, KeepsTheReferenceMapBeforeWhenANewOneIsStopped) {
  const Scene scene(8);
  MapMatcher matcher;
  work::StopToken stop;
  stop.requestStop();

  EXPECT_FALSE(matcher.setReference(scene.reference, stop));
  EXPECT_FALSE(matcher.hasReference());

  EXPECT_TRUE(matcher.setReference(scene.reference));
  const MatchResult before = matcher.match(*scene.session);
  EXPECT_FALSE(matcher.setReference(test::asciiMap({"#.", ".."}), stop));
  EXPECT_EQ(matcher.match(*scene.session).reference_time, before.reference_time);
  EXPECT_TRUE(before.matched());
}

TEST(MapMatcher, KeepsTheReferenceMapBeforeWhenANewOneThrows) {
  const Scene scene(8);
  MapMatcher matcher;
  {
    const test::NoThreads no_threads;
    EXPECT_THROW(matcher.setReference(scene.reference), std::system_error);
  }
  EXPECT_FALSE(matcher.hasReference());
  EXPECT_EQ(matcher.match(*scene.session).status, MatchStatus::kNoReference);

  matcher.setReference(scene.reference);
  const MatchResult before = matcher.match(*scene.session);
  {
    const test::NoThreads no_threads;
    EXPECT_THROW(matcher.setReference(test::asciiMap({"####"})), std::system_error);
  }
  const MatchResult after = matcher.match(*scene.session);

  ASSERT_TRUE(before.matched()) << before.reason;
  EXPECT_EQ(after.T_reference_session.x, before.T_reference_session.x);
  EXPECT_EQ(after.reference_time, before.reference_time);
}

TEST(MapMatcher, EndsTheTwoStagesAtTheDeadlineToo) {
  const Scene scene(17);
  MatchOptions options;
  options.search = "two_stage";
  options.exact_deadline = 0.0;

  const MatchResult result = match(scene, options);

  EXPECT_EQ(result.status, MatchStatus::kNotCertified);
  EXPECT_NE(result.reason.find("the time was over in the coarse stage"), std::string::npos) << result.reason;
}

TEST(SearchReference, IsGivenUpAtEveryLookAtItsDeadlineOrWhole) {
  const grid::OccupancyGrid map = test::asciiMap({"####..#", "#.....#", "#..#..#", "#######"}, kResolution);
  const MatchOptions options;
  for (const double resolution : {kResolution, 0.08}) {
    long look = 0;
    for (bool whole = false; !whole;) {
      const test::Cut cut(++look);
      try {
        const SearchReference reference(map, resolution, options, cut.deadline());
        whole = true;
        EXPECT_TRUE(reference.hasWalls());
      } catch (const work::DeadlinePassed&) {
        EXPECT_TRUE(cut.reached());
      }
    }
    EXPECT_GT(look, 50);
  }
}

TEST(MapMatcher, RejectsEveryOptionOutOfRangeByNameValueAndRange) {
  MatchOptions options;
  options.coarse.acceptance_ratio = 1.5;
  options.hits_sample_threshold = -3;
  options.coarse_resolution = std::nan("");
  options.hit_tolerance = std::nan("");
  options.threads = -1;
  options.search = "magic";

  try {
    MapMatcher matcher(options);
    FAIL() << "expected std::invalid_argument";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("acceptance_ratio is 1.5, expected 0 to 1"), std::string::npos) << text;
    EXPECT_NE(text.find("hits_sample_threshold is -3"), std::string::npos) << text;
    EXPECT_NE(text.find("coarse_resolution is nan"), std::string::npos) << text;
    EXPECT_NE(text.find("hit_tolerance is nan"), std::string::npos) << text;
    EXPECT_NE(text.find("threads is -1"), std::string::npos) << text;
    EXPECT_NE(text.find("two_stage | exact"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace map_matcher::search
