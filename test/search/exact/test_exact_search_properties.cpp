// Laws of the exact search, on random small problems. The seeds are fixed and named in every failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>

#include "map_matcher/search/exact/exact_search.hpp"
#include "support/exact_oracle.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

/// A random small map and session. Half of the sessions are a part of the map, the others match nothing well.
struct RandomProblem {
  explicit RandomProblem(std::uint32_t seed, int largest = 18) : random(seed) {
    width = test::randomInt(random, 1, largest);
    height = test::randomInt(random, 1, largest);
    walls = test::randomCells(random, width, height, test::randomInt(random, 1, 1 + width * height / 4));
    tolerance = std::min<double>(0.5 * test::randomInt(random, 0, 5), width + height);
    drawSession();
    const double step = rotationStep(1.0, session.diagonal);
    const int all = static_cast<int>(std::lround(2.0 * M_PI / step));
    const int count = random() % 2 == 0 ? all : test::randomInt(random, 1, all);
    const double first_angle = random() % 2 == 0 ? 0.0 : test::randomReal(random, -3.0, 3.0);
    rotations = std::make_unique<RotationBlocks>(session, first_angle, step, count, BlockShape::kMaxLevel);
  }

  void drawSession() {
    const int size = test::randomInt(random, 1, 9);
    std::vector<grid::Cell> cells = test::randomCells(random, size, size, test::randomInt(random, 1, 25));
    if (random() % 2 == 0) {
      const grid::Cell corner = walls[random() % walls.size()];
      std::vector<grid::Cell> part;
      std::copy_if(walls.begin(), walls.end(), std::back_inserter(part), [&](const grid::Cell& wall) {
        return std::abs(wall.x - corner.x) <= size / 2 && std::abs(wall.y - corner.y) <= size / 2;
      });
      cells = part;
    }
    const double resolution = test::randomInt(random, 0, 3) == 0 ? 0.1 : 0.05;  // of the map; the session's is 0.05
    session = prepareSessionCells(cells, 0.05, resolution, CellMerging::kNone, 0);
  }

  ExactProblem problem(const WidenedGrids& grids) {
    ExactProblem problem{grids, *rotations, {}};
    const int n = rotations->numCells();
    problem.min_count = test::randomInt(random, 1, n);
    problem.distinction = {test::randomReal(random, 0.0, 6.0), test::randomReal(random, 0.0, 2.0)};
    problem.runner_up_gap = test::randomInt(random, 0, n);
    if (random() % 3 == 0) {
      for (int k = 0; k < rotations->count(); ++k) {
        const grid::Cell first{test::randomInt(random, -9, 15), test::randomInt(random, -9, 15)};
        problem.windows.push_back(
            {first, {first.x + test::randomInt(random, -1, 9), first.y + test::randomInt(random, -1, 9)}});
      }
    }
    return problem;
  }

  std::mt19937 random;
  int width;
  int height;
  std::vector<grid::Cell> walls;
  double tolerance;
  SessionCells session;
  std::unique_ptr<RotationBlocks> rotations;
};

void expectEqual(const std::optional<SearchPose>& found, const std::optional<SearchPose>& expected) {
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (expected) {
    EXPECT_EQ(found->count, expected->count);
    EXPECT_EQ(found->rotation, expected->rotation);
    EXPECT_EQ(found->translation, expected->translation);
  }
}

TEST(ExactSearch, FindsWhatTryingAllPosesFindsWithAnyNumberOfThreadsAndEveryKernel) {
  const std::vector<KernelVariant> variants = availableKernelVariants();
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomProblem random(seed);
    ExactSettings settings;
    const int top_level = static_cast<int>(seed) % (BlockShape::kMaxLevel + 1);
    const WidenedGrids grids(random.width, random.height, random.walls, random.tolerance, top_level);
    ExactProblem problem = random.problem(grids);
    const test::HitMap hits(random.width, random.height, random.walls, random.tolerance);
    const test::BestPoses expected = test::tryAllPoses(problem, random.session, hits, 32);

    for (const KernelVariant variant : variants) {
      settings.kernel = ScoreKernel(variant);
      const int root_level = test::randomInt(random.random, 0, top_level);
      settings.root_level = variant == variants.back() ? std::nullopt : std::make_optional(root_level);
      settings.threads = 1 + static_cast<int>((seed + static_cast<std::uint32_t>(variant)) % 3);
      problem.known_count =
          seed % 4 == 0 && expected.best ? expected.best->count - test::randomInt(random.random, 0, 2) : 0;
      const ExactOutcome outcome = exactSearch(problem, settings);

      ASSERT_TRUE(outcome.best_proven && outcome.runner_up_proven);
      expectEqual(outcome.best, expected.best);
      expectEqual(outcome.runner_up, expected.runner_up);
      if (expected.best) {
        EXPECT_EQ(outcome.upper_bound, expected.best->count);
      } else {
        EXPECT_EQ(outcome.upper_bound, problem.min_count - 1);
      }
      ASSERT_FALSE(HasFailure());
    }
  }
}

/// What a pose is worth: up to half of its matches less than them, at random but always the same.
double someWorth(const SearchPose& pose) {
  const int lost = (pose.rotation * 7 + pose.translation.x * 13 + pose.translation.y * 29) % 11;
  return pose.count * (1.0 - 0.05 * std::abs(lost));
}

TEST(ExactSearch, FindsThePlacesThatTakingTheBestOfAllPosesAgainAndAgainFinds) {
  int further_places = 0;
  for (std::uint32_t seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomProblem random(seed);
    const int top_level = static_cast<int>(seed) % (BlockShape::kMaxLevel + 1);
    const WidenedGrids grids(random.width, random.height, random.walls, random.tolerance, top_level);
    ExactProblem problem = random.problem(grids);
    problem.most_places = test::randomInt(random.random, 1, 6);
    problem.runner_up_gap /= test::randomInt(random.random, 1, 4);
    if (seed % 3 != 0) {
      problem.worth = someWorth;
    }
    const test::HitMap hits(random.width, random.height, random.walls, random.tolerance);
    const test::BestPoses truth = test::tryAllPoses(problem, random.session, hits, 32);
    const std::vector<SearchPose> expected = test::greedyPlaces(problem, truth);
    ExactSettings settings;
    settings.threads = 1 + static_cast<int>(seed % 3);
    settings.most_stored_nodes = seed % 5 == 0 ? 20 : settings.most_stored_nodes;

    const ExactOutcome outcome = exactSearch(problem, settings);

    ASSERT_TRUE(outcome.complete);
    ASSERT_EQ(outcome.places.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      expectEqual(outcome.places[k], expected[k]);
    }
    const std::optional<SearchPose> next = test::bestElsewhere(problem, truth.poses, outcome.places, 1);
    EXPECT_GE(outcome.elsewhere_bound, next ? next->count : 0);
    EXPECT_LE(outcome.elsewhere_bound, expected.empty() ? problem.min_count - 1 : expected.back().count);
    further_places += static_cast<int>(expected.size()) - 2;
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(further_places, 100);
}

TEST(ExactSearch, NoPoseOfANodeBeatsItsBound) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomProblem random(seed, 60);
    const WidenedGrids grids(random.width, random.height, random.walls, random.tolerance, BlockShape::kMaxLevel);
    const test::HitMap hits(random.width, random.height, random.walls, random.tolerance);
    const ScoreKernel kernel;
    for (int level = 0; level <= BlockShape::kMaxLevel; ++level) {
      const BlockShape shape{level};
      const int blocks = (random.rotations->count() + shape.stride() - 1) / shape.stride();
      const int rotation = shape.stride() * test::randomInt(random.random, 0, blocks - 1);
      const int grain = shape.grain();
      const grid::Cell first{test::randomInt(random.random, -80, 80) * grain,
                             test::randomInt(random.random, -80, 80) * grain};
      std::vector<TileScore> bounds;
      kernel.scoreTile(grids.level(level), random.rotations->cells(shape, rotation), grids.position(level, first), {},
                       0, bounds);
      for (int trial = 0; trial < 40; ++trial) {
        const int turn = test::randomInt(random.random, 0, shape.stride() - 1);
        const RotatedCells cells = rotate(random.session, random.rotations->angle(rotation + turn));
        const int dx = test::randomInt(random.random, 0, shape.stride() * kTileColumns - 1);
        const int dy = test::randomInt(random.random, 0, shape.stride() * kTileRows - 1);
        const auto node = static_cast<std::size_t>(dx / shape.stride() * kTileRows + dy / shape.stride());
        ASSERT_LE(hits.count(cells, {first.x + dx, first.y + dy}), bounds[node].count) << "level " << level;
      }
    }
  }
}

TEST(ExactSearch, WithoutTimeSaysThatNothingIsProvenAndBoundsTheRest) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomProblem random(seed);
    const WidenedGrids grids(random.width, random.height, random.walls, random.tolerance, 3);
    ExactProblem problem = random.problem(grids);
    ExactSettings settings;
    settings.root_level = 3;
    const ExactOutcome complete = exactSearch(problem, settings);
    settings.deadline = work::Deadline(0.0);

    const ExactOutcome outcome = exactSearch(problem, settings);

    EXPECT_FALSE(outcome.best_proven && outcome.best);
    EXPECT_FALSE(outcome.stopped);
    EXPECT_GE(outcome.upper_bound, complete.best ? complete.best->count : 0);
  }
}

}  // namespace
}  // namespace map_matcher::search
