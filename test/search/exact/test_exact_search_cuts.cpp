// What an exact search says when it is cut, at every look at its deadline, held against all poses. The seeds are fixed
// and named in every failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <random>
#include <string>

#include "map_matcher/search/exact/exact_search.hpp"
#include "support/cut.hpp"
#include "support/exact_oracle.hpp"
#include "support/random_maps.hpp"
#include "support/repeated_rooms.hpp"

namespace map_matcher::search {
namespace {

constexpr int kMapSize = 26;  // [cells]
constexpr int kReach = 40;    // of translations beyond which nothing matches [cells]

/// A room that comes again at turned headings, and a session that is a part of it.
struct RepeatedRoom {
  explicit RepeatedRoom(std::uint32_t seed) : random(seed) {
    const int size = test::randomInt(random, 4, 7);
    const std::vector<grid::Cell> room =
        test::randomCells(random, size, size, test::randomInt(random, 6, size * size / 2));
    const int copies = test::randomInt(random, 2, 4);
    for (int k = 0; k < copies; ++k) {
      const double angle = k == 0 ? 0.0 : test::randomTurn(random);
      const Eigen::Vector2d middle(0.5 * size + test::randomInt(random, 2, kMapSize - size - 2),
                                   0.5 * size + test::randomInt(random, 2, kMapSize - size - 2));
      const std::vector<grid::Cell> copy =
          test::thinned(random, test::turnedCopy(room, size, angle, middle), random() % 2 == 0 ? 0 : 20);
      walls.insert(walls.end(), copy.begin(), copy.end());
    }
    walls.push_back({test::randomInt(random, 0, kMapSize - 1), test::randomInt(random, 0, kMapSize - 1)});
    tolerance = 0.5 * test::randomInt(random, 0, 3);
    std::vector<grid::Cell> seen = test::thinned(random, room, random() % 2 == 0 ? 0 : 15);
    seen.push_back(room.front());
    session = prepareSessionCells(seen, 0.05, 0.05, CellMerging::kNone, 0);
    const double step = rotationStep(1.0, session.diagonal);
    const int all = static_cast<int>(std::lround(2.0 * M_PI / step));
    rotations = std::make_unique<RotationBlocks>(session, 0.0, step, all, BlockShape::kMaxLevel);
  }

  /// The problem, and in how far it is cut down: `pose` is the best of all.
  ExactProblem problem(const WidenedGrids& grids, const std::optional<SearchPose>& pose) {
    ExactProblem problem{grids, *rotations, {}};
    const int n = rotations->numCells();
    problem.min_count = test::randomInt(random, 1, n);
    problem.runner_up_gap = test::randomInt(random, 0, n);
    const bool known = pose && random() % 3 == 0;
    problem.known_count = known ? pose->count - test::randomInt(random, 0, 2) : 0;
    problem.most_places = test::randomInt(random, 1, 5);
    if (random() % 2 == 0) {
      problem.worth = [](const SearchPose& place) { return place.count * (1.0 - 0.1 * (place.rotation % 5)); };
    }
    return problem;
  }

  std::mt19937 random;
  std::vector<grid::Cell> walls;
  double tolerance;
  SessionCells session;
  std::unique_ptr<RotationBlocks> rotations;
};

/// What was said of how many cuts, and how much of it is wrong.
struct Tally {
  long cuts = 0;
  long proven = 0;            // of the best pose
  long runner_up_proven = 0;  // and of the runner-up
  long wrong_upper_bounds = 0;
  long wrong_runner_up_bounds = 0;
  long further_places = 0;  // beyond the runner-up, at all cuts
  long wrong_elsewhere_bounds = 0;
  long wrong_poses = 0;  // said to be proven, or better than the best of all
  long loose_bounds = 0;
  std::string first_wrong;

  bool flawless() const {
    return wrong_upper_bounds + wrong_runner_up_bounds + wrong_elsewhere_bounds + wrong_poses + loose_bounds == 0;
  }

  friend std::ostream& operator<<(std::ostream& out, const Tally& tally) {
    return out << tally.cuts << " cuts, " << tally.proven << " of them with a proof of the best pose and "
               << tally.runner_up_proven << " of the runner-up, too, and " << tally.further_places
               << " further places; wrong: " << tally.wrong_upper_bounds << " upper bounds, "
               << tally.wrong_runner_up_bounds << " bounds of runners-up, " << tally.wrong_elsewhere_bounds
               << " bounds of places elsewhere, " << tally.wrong_poses << " poses; too loose: " << tally.loose_bounds
               << " bounds; the first in " << tally.first_wrong;
  }
};

bool same(const std::optional<SearchPose>& a, const std::optional<SearchPose>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->count == b->count && a->rotation == b->rotation && a->translation == b->translation));
}

/// Adds what is wrong with the places of a search and with what is said of all others.
void checkPlaces(const ExactProblem& problem, const test::BestPoses& truth, const std::vector<SearchPose>& expected,
                 const ExactOutcome& outcome, Tally& tally) {
  const std::vector<SearchPose>& places = outcome.places;
  tally.further_places += std::max<long>(0, static_cast<long>(places.size()) - 2);
  const std::optional<SearchPose> next = test::bestElsewhere(problem, truth.poses, places, 1);
  tally.wrong_elsewhere_bounds += outcome.elsewhere_bound < (next ? next->count : 0) ? 1 : 0;
  tally.loose_bounds += outcome.elsewhere_bound > outcome.upper_bound ? 1 : 0;
  if (places.size() > expected.size() || (outcome.complete && places.size() < expected.size())) {
    ++tally.wrong_poses;
    return;
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool may_be_worse = !outcome.complete && k + 1 == places.size();
    const bool right = same(places[k], expected[k]) || (may_be_worse && places[k].count <= expected[k].count);
    tally.wrong_poses += right ? 0 : 1;
  }
  if (outcome.complete && !places.empty()) {
    tally.loose_bounds += outcome.elsewhere_bound > places.back().count ? 1 : 0;
  }
}

/// Adds what is wrong with the outcome of a search to the tally. `truth` are the best poses of all, few hits or many.
void check(const ExactProblem& problem, const test::BestPoses& truth, const ExactOutcome& outcome, Tally& tally) {
  const auto count = [](const std::optional<SearchPose>& pose) { return pose ? pose->count : 0; };
  const auto from = [](const std::optional<SearchPose>& pose, int least) {
    return pose && pose->count >= std::max(1, least) ? pose : std::nullopt;
  };
  tally.wrong_upper_bounds += outcome.upper_bound < count(truth.best) ? 1 : 0;
  tally.loose_bounds += outcome.upper_bound > problem.rotations.numCells() ? 1 : 0;
  tally.wrong_poses += count(outcome.best) > count(truth.best) ? 1 : 0;
  if (!outcome.best_proven) {
    tally.wrong_poses += outcome.runner_up_proven || outcome.runner_up ? 1 : 0;
    return;
  }
  ++tally.proven;
  tally.wrong_poses += same(outcome.best, from(truth.best, problem.min_count)) ? 0 : 1;
  if (!outcome.best) {
    return;
  }
  tally.loose_bounds += outcome.upper_bound > outcome.best->count ? 1 : 0;
  tally.wrong_runner_up_bounds += outcome.runner_up_bound < count(truth.runner_up) ? 1 : 0;
  tally.loose_bounds += outcome.runner_up_bound > outcome.best->count ? 1 : 0;
  tally.wrong_poses += count(outcome.runner_up) > count(truth.runner_up) ? 1 : 0;
  if (outcome.runner_up_proven) {
    ++tally.runner_up_proven;
    const int least = outcome.best->count - problem.runner_up_gap;
    tally.wrong_poses += same(outcome.runner_up, from(truth.runner_up, least)) ? 0 : 1;
    tally.loose_bounds += outcome.runner_up_bound > std::max(count(outcome.runner_up), std::max(1, least) - 1) ? 1 : 0;
  }
}

/// Cuts a search at every look until it ends by itself, and returns what it found then.
ExactOutcome cutEverywhere(const ExactProblem& problem, ExactSettings settings, const test::BestPoses& truth,
                           const std::string& name, Tally& tally) {
  const std::vector<SearchPose> expected = test::greedyPlaces(problem, truth);
  for (long look = 1;; ++look) {
    const bool flawless = tally.flawless();
    const test::Cut cut(look);
    settings.deadline = cut.deadline();
    const ExactOutcome outcome = exactSearch(problem, settings);
    checkPlaces(problem, truth, expected, outcome, tally);
    check(problem, truth, outcome, tally);
    if (flawless && !tally.flawless()) {
      tally.first_wrong = name + ", look " + std::to_string(look);
    }
    if (!cut.reached()) {
      return outcome;
    }
    ++tally.cuts;
  }
}

TEST(ExactSearchCuts, SayNothingThatAllPosesContradict) {
  Tally alone;
  Tally together;
  for (std::uint32_t seed = 0; seed < 80; ++seed) {
    const std::string name = "seed " + std::to_string(seed);
    SCOPED_TRACE(name);
    RepeatedRoom room(seed);
    const int top_level = test::randomInt(room.random, 2, BlockShape::kMaxLevel);
    const WidenedGrids grids(kMapSize, kMapSize, room.walls, room.tolerance, top_level);
    ExactProblem everything{grids, *room.rotations, {}};
    everything.distinction = {test::randomReal(room.random, 1.0, 5.0), test::randomReal(room.random, 0.1, 1.0)};
    const test::HitMap hits(kMapSize, kMapSize, room.walls, room.tolerance);
    const test::BestPoses truth = test::tryAllPoses(everything, room.session, hits, kReach);
    ExactProblem problem = room.problem(grids, truth.best);
    problem.distinction = everything.distinction;
    ExactSettings settings;
    const int root_level = test::randomInt(room.random, 0, 3);
    settings.root_level = root_level == 0 ? std::nullopt : std::make_optional(std::min(root_level, top_level));

    settings.most_stored_nodes = seed % 3 == 0 ? 20 : settings.most_stored_nodes;

    const ExactOutcome whole = cutEverywhere(problem, settings, truth, name, alone);
    settings.threads = 2 + static_cast<int>(seed % 2);
    const ExactOutcome whole_together = cutEverywhere(problem, settings, truth, name, together);

    EXPECT_TRUE(whole.best_proven && whole.complete);
    EXPECT_TRUE(whole_together.best_proven && whole_together.complete);
  }
  std::cout << "one thread: " << alone << "\nseveral threads: " << together << '\n';
  EXPECT_GT(alone.cuts, 1000);
  EXPECT_GT(together.cuts, 1000);
  EXPECT_GT(alone.further_places, 1000);
  EXPECT_TRUE(alone.flawless()) << alone;
  EXPECT_TRUE(together.flawless()) << together;
}

}  // namespace
}  // namespace map_matcher::search
