// Laws of the search, on random small problems. The seeds are fixed and named in every failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "map_matcher/search/two_stage/branch_and_bound.hpp"
#include "map_matcher/search/two_stage/scouting.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

constexpr int kTopLevel = 4;

/// A random search: a map with walls in lines, several rotations of a session map and a window each.
struct RandomSearch {
  explicit RandomSearch(std::uint32_t seed) : random(seed) {
    const int width = test::randomInt(random, 5, 60);
    const int height = test::randomInt(random, 5, 60);
    const int num_walls = test::randomInt(random, 10, width * height / 3);
    grids.emplace_back(width, height, test::randomCells(random, width, height, num_walls), kTopLevel);
    const int num_cells = test::randomInt(random, 1, 300);
    const int num_rotations = test::randomInt(random, 1, 5);
    for (int n = 0; n < num_rotations; ++n) {
      rotations.push_back(test::randomRotatedCells(random, 20, num_cells));
      const grid::Cell first{test::randomInt(random, -30, 30), test::randomInt(random, -30, 30)};
      windows.push_back({first, {first.x + test::randomInt(random, 0, 40), first.y + test::randomInt(random, 0, 40)}});
    }
  }

  SearchProblem problem(int root_level) const {
    const auto cells = [this](int n) { return rotations[static_cast<std::size_t>(n)]; };
    return {grids[0], cells, windows, {}, 1, root_level};
  }

  std::mt19937 random;
  std::vector<PrecomputedGrids> grids;
  std::vector<RotatedCells> rotations;
  std::vector<SearchWindow> windows;
};

TEST(BranchAndBound, FindsWhatAnExhaustiveSearchFinds) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomSearch search(seed);
    const std::int32_t expected = test::exhaustiveBest(search.grids[0], search.rotations, search.windows);
    const int root_level = static_cast<int>(seed) % (kTopLevel + 1);

    const SearchOutcome outcome = branchAndBound(search.problem(root_level));

    ASSERT_EQ(outcome.best.has_value(), expected > 0);
    if (outcome.best) {
      const auto n = static_cast<std::size_t>(outcome.best->rotation);
      const grid::Cell& t = outcome.best->translation;
      ASSERT_EQ(outcome.best->count, expected);
      ASSERT_EQ(test::countMatches(search.grids[0].level(0), search.rotations[n], t), expected);
      ASSERT_TRUE(t.x >= search.windows[n].first.x && t.x <= search.windows[n].last.x);
      ASSERT_TRUE(t.y >= search.windows[n].first.y && t.y <= search.windows[n].last.y);
    }
  }
}

/// A random map and a session that turns, in bands of rotations.
struct TurningSearch {
  explicit TurningSearch(std::uint32_t seed) : random(seed) {
    const int width = test::randomInt(random, 5, 60);
    const int height = test::randomInt(random, 5, 60);
    const std::vector<grid::Cell> walls =
        test::randomCells(random, width, height, test::randomInt(random, 10, width * height / 3));
    grids.emplace_back(width, height, walls, kTopLevel, test::randomInt(random, 0, kTopLevel));
    const int size = test::randomInt(random, 1, 12);
    session = prepareSessionCells(test::randomCells(random, size, size, test::randomInt(random, 1, 60)), 0.05, 0.05,
                                  CellMerging::kMerge, 0);
    angles = allRotations(test::randomReal(random, 1.0, 4.0), session.diagonal);
    for (const double angle : angles) {
      rotations.push_back(rotate(session, angle));
      const grid::Cell first{test::randomInt(random, -30, 30), test::randomInt(random, -30, 30)};
      windows.push_back(
          {first, {first.x + test::randomInt(random, -1, 120), first.y + test::randomInt(random, -1, 120)}});
    }
  }

  SearchProblem problem() {
    const auto cells = [this](int n) { return rotations[static_cast<std::size_t>(n)]; };
    SearchProblem problem{grids[0], cells, windows, {}, 1, test::randomInt(random, 0, kTopLevel)};
    problem.bands = rotationBands(session, angles);
    problem.turned = [this](double angle) { return rotate(session, angle); };
    problem.threads = test::randomInt(random, 1, 3);
    return problem;
  }

  std::mt19937 random;
  std::vector<PrecomputedGrids> grids;
  SessionCells session;
  std::vector<double> angles;
  std::vector<RotatedCells> rotations;
  std::vector<SearchWindow> windows;
};

TEST(BranchAndBound, WithBandsOfRotationsAndThreadsFindsTheFirstOfTheBestPoses) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TurningSearch search(seed);
    const SearchPose expected = test::firstOfTheBest(search.grids[0], search.rotations, search.windows);
    SearchProblem problem = search.problem();
    if (seed % 2 == 0) {
      putPromisingFirst(problem, search.session, 16);
    }

    const SearchOutcome outcome = branchAndBound(problem);

    ASSERT_EQ(outcome.best.has_value(), expected.count > 0);
    if (outcome.best) {
      ASSERT_EQ(outcome.best->count, expected.count);
      ASSERT_EQ(outcome.best->rotation, expected.rotation);
      ASSERT_EQ(outcome.best->translation, expected.translation);
    }
  }
}

TEST(BranchAndBound, ParentIsNeverBeatenByAChild) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomSearch search(seed);
    for (int level = 1; level <= kTopLevel; ++level) {
      const PooledLevel& parent = search.grids[0].level(level);
      const PooledLevel& child = search.grids[0].level(level - 1);
      for (int trial = 0; trial < 20; ++trial) {
        const grid::Cell t{test::randomInt(search.random, -50, 80), test::randomInt(search.random, -50, 80)};
        const std::int32_t bound = test::countMatches(parent, search.rotations[0], t);
        for (int k = 0; k < 4; ++k) {
          const grid::Cell first{t.x + (k & 1) * child.stride(), t.y + (k >> 1) * child.stride()};
          ASSERT_GE(bound, test::countMatches(child, search.rotations[0], first)) << "level " << level;
        }
      }
    }
  }
}

TEST(BranchAndBound, AnswersNothingWhenNothingReachesTheThresholdAndElseTheSame) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomSearch search(seed);
    const std::int32_t best = test::exhaustiveBest(search.grids[0], search.rotations, search.windows);
    SearchProblem reachable = search.problem(3);
    reachable.min_count = std::max(1, best);
    SearchProblem out_of_reach = search.problem(3);
    out_of_reach.min_count = best + 1;

    EXPECT_EQ(branchAndBound(reachable).best.has_value(), best > 0);
    EXPECT_FALSE(branchAndBound(out_of_reach).best.has_value());
  }
}

TEST(BranchAndBound, OrderOfTheInitialListDoesNotChangeTheScore) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomSearch search(seed);
    SearchProblem ordered = search.problem(3);
    for (std::size_t n = 0; n < search.rotations.size(); ++n) {
      ordered.order.push_back(static_cast<std::int32_t>(search.rotations.size() - n));
    }

    const SearchOutcome by_order = branchAndBound(ordered);
    const SearchOutcome by_score = branchAndBound(search.problem(3));

    ASSERT_EQ(by_order.best.has_value(), by_score.best.has_value());
    if (by_score.best) {
      EXPECT_EQ(by_order.best->count, by_score.best->count);
    }
  }
}

TEST(BranchAndBound, PassesOverTheEmptyPartOfANarrowWindow) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomSearch search(seed);
    for (SearchWindow& window : search.windows) {
      window.first = {window.first.x, -100};
      window.last = {window.first.x + 3, 200};
    }
    const std::int32_t expected = test::exhaustiveBest(search.grids[0], search.rotations, search.windows);
    for (SearchWindow& window : search.windows) {
      window = {{window.first.x, everywhere().first.y}, {window.last.x, everywhere().last.y}};
    }

    const SearchOutcome outcome = branchAndBound(search.problem(2));

    ASSERT_EQ(outcome.best ? outcome.best->count : 0, expected);
    EXPECT_LT(outcome.nodes_scored, 1000000);
  }
}

TEST(BranchAndBound, GivesTheSamePoseOnEveryRun) {
  const RandomSearch search(3);

  const SearchOutcome once = branchAndBound(search.problem(2));
  const SearchOutcome again = branchAndBound(search.problem(2));

  ASSERT_TRUE(once.best && again.best);
  EXPECT_EQ(once.best->rotation, again.best->rotation);
  EXPECT_EQ(once.best->translation, again.best->translation);
  EXPECT_EQ(once.nodes_scored, again.nodes_scored);
}

TEST(BranchAndBound, StopsWhenItIsTold) {
  const RandomSearch search(3);
  work::StopToken stop;
  stop.requestStop();

  const SearchOutcome outcome = branchAndBound(search.problem(2), work::Deadline(1.0, stop));

  EXPECT_TRUE(outcome.stopped);
  EXPECT_FALSE(outcome.best.has_value());
  EXPECT_EQ(outcome.nodes_scored, 0);
}

}  // namespace
}  // namespace map_matcher::search
