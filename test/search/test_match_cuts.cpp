// What a match says when it is cut, at every look at its deadline, held against the match that is not. The seeds are
// fixed and named in every failure.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <random>
#include <string>

#include "map_matcher/search/map_matcher.hpp"
#include "support/cut.hpp"
#include "support/random_maps.hpp"
#include "support/repeated_rooms.hpp"

namespace map_matcher::search {
namespace {

constexpr double kResolution = 0.1;
constexpr int kRoomSize = 20;  // [cells]
constexpr int kMapSize = 70;   // [cells]

/// A room with things in it.
std::vector<grid::Cell> randomRoom(std::mt19937& random) {
  std::vector<grid::Cell> room;
  for (int k = 0; k < kRoomSize; ++k) {
    for (const grid::Cell& cell :
         {grid::Cell{k, 0}, grid::Cell{k, kRoomSize - 1}, grid::Cell{0, k}, grid::Cell{kRoomSize - 1, k}}) {
      room.push_back(cell);
    }
  }
  for (int wall = 0; wall < 3; ++wall) {
    const grid::Cell first{test::randomInt(random, 1, kRoomSize - 2), test::randomInt(random, 1, kRoomSize - 2)};
    const bool along_x = random() % 2 == 0;
    const int length = test::randomInt(random, 3, 9);
    for (int k = 0; k < length; ++k) {
      const grid::Cell cell{first.x + (along_x ? k : 0), first.y + (along_x ? 0 : k)};
      if (cell.x < kRoomSize && cell.y < kRoomSize) {
        room.push_back(cell);
      }
    }
  }
  return room;
}

grid::OccupancyGrid gridOf(const std::vector<grid::Cell>& walls, int size) {
  grid::OccupancyGrid grid({kResolution, size, size, {}});
  for (const grid::Cell& wall : walls) {
    if (grid.geometry().contains(wall)) {
      grid.at(wall.x, wall.y) = grid::kOccupied;
    }
  }
  return grid;
}

/// A building in which a room comes two or three times, at turned headings, and a session map of it.
struct RepeatedRoom {
  explicit RepeatedRoom(std::uint32_t seed) : random(seed) {
    const std::vector<grid::Cell> room = randomRoom(random);
    std::vector<grid::Cell> walls;
    const std::vector<Eigen::Vector2d> middles{{18.0, 18.0}, {52.0, 20.0}, {32.0, 52.0}};
    const std::size_t copies = 2 + random() % 2;
    for (std::size_t k = 0; k < copies; ++k) {
      const double angle = k == 0 ? 0.3 * static_cast<double>(random() % 2) : test::randomTurn(random);
      const std::vector<grid::Cell> copy = test::thinned(random, test::turnedCopy(room, kRoomSize, angle, middles[k]),
                                                         4 * static_cast<int>(random() % 4));
      walls.insert(walls.end(), copy.begin(), copy.end());
    }
    reference = std::make_unique<grid::OccupancyGrid>(gridOf(walls, kMapSize));
    session = std::make_unique<grid::OccupancyGrid>(gridOf(test::thinned(random, room, 5), kRoomSize));
    options.coarse_resolution = 0.2;
    options.hit_tolerance = random() % 2 == 0 ? 0.0 : 0.1;
    options.min_session_cells = 10;
    options.distinct_distance = 0.5;
    options.coarse.acceptance_ratio = 0.4;
    options.min_hit_ratio = 0.5;
    options.min_margin = 0.02 * static_cast<double>(random() % 8);
  }

  MatchResult match(const MatchPrior& prior, const work::Deadline& deadline) const {
    MapMatcher matcher(options);
    matcher.setReference(*reference);
    return matcher.match(*session, prior, deadline);
  }

  std::mt19937 random;
  std::unique_ptr<grid::OccupancyGrid> reference;
  std::unique_ptr<grid::OccupancyGrid> session;
  MatchOptions options;
};

/// What was said of how many cuts, and how much of it is wrong.
struct Tally {
  long cuts = 0;
  std::map<std::string, long> statuses;
  long wrong_verdicts = 0;
  long wrong_poses = 0;
  long wrong_bounds = 0;
  long wrong_margins = 0;
  std::string first_wrong;

  bool flawless() const { return wrong_verdicts + wrong_poses + wrong_bounds + wrong_margins == 0; }

  friend std::ostream& operator<<(std::ostream& out, const Tally& tally) {
    out << tally.cuts << " cuts:";
    for (const auto& [status, count] : tally.statuses) {
      out << ' ' << count << ' ' << status << ',';
    }
    return out << " wrong: " << tally.wrong_verdicts << " verdicts, " << tally.wrong_poses << " poses, "
               << tally.wrong_bounds << " upper bounds, " << tally.wrong_margins << " margins; the first in "
               << tally.first_wrong;
  }
};

bool samePose(const grid::Rigid2& a, const grid::Rigid2& b) { return a.x == b.x && a.y == b.y && a.yaw == b.yaw; }

/// Best pose of a result in whole cells.
grid::Rigid2 wholeCells(const MatchResult& result) {
  return result.searched ? *result.searched : result.T_reference_session;
}

/// Adds what is wrong with a match that was cut to the tally. `whole` is the match that was not, and `truth` the same
/// with any share of hits and any margin, so that it has the best place elsewhere.
void check(const MatchResult& cut, const MatchResult& whole, const MatchResult& truth, Tally& tally) {
  constexpr double kRounding = 1e-9;
  const bool undecided = cut.status == MatchStatus::kNotCertified || cut.status == MatchStatus::kStopped;
  tally.wrong_verdicts += undecided || cut.status == whole.status ? 0 : 1;
  if (cut.matched()) {
    tally.wrong_poses += samePose(cut.T_reference_session, whole.T_reference_session) ? 0 : 1;
  }
  tally.wrong_bounds += cut.upper_bound < truth.hit_ratio - kRounding ? 1 : 0;
  if (cut.certified) {
    const bool found = whole.hit_cells > 0 && cut.hit_cells > 0;
    tally.wrong_poses += cut.hit_cells == whole.hit_cells && whole.certified ? 0 : 1;
    tally.wrong_poses += !found || samePose(wholeCells(cut), wholeCells(whole)) ? 0 : 1;
  }
  const double true_margin = truth.hit_ratio - (truth.runner_up ? truth.runner_up->ratio : 0.0);
  tally.wrong_margins += cut.margin > true_margin + kRounding ? 1 : 0;
  tally.wrong_margins += cut.runner_up && cut.runner_up->ratio > truth.hit_ratio - true_margin + kRounding ? 1 : 0;
}

/// Cuts a match at every look until it ends by itself.
void cutEverywhere(const RepeatedRoom& room, const MatchPrior& prior, test::Cut::Kind kind, const std::string& name,
                   Tally& tally) {
  const MatchResult whole = room.match(prior, work::Deadline());
  RepeatedRoom any = RepeatedRoom(0);
  any.reference = std::make_unique<grid::OccupancyGrid>(*room.reference);
  any.session = std::make_unique<grid::OccupancyGrid>(*room.session);
  any.options = room.options;
  any.options.min_hit_ratio = any.options.coarse.acceptance_ratio = 0.2;
  any.options.min_margin = 1.0;
  const MatchResult truth = any.match(prior, work::Deadline());
  MapMatcher matcher(room.options);
  matcher.setReference(*room.reference);
  bool reached = true;
  for (long look = 1; reached; ++look) {
    const test::Cut cut(look, kind);
    const MatchResult result = matcher.match(*room.session, prior, cut.deadline());
    reached = cut.reached();
    const bool flawless = tally.flawless();
    check(result, whole, truth, tally);
    if (flawless && !tally.flawless()) {
      tally.first_wrong = name + ", look " + std::to_string(look) + ": " + result.reason + " | " + whole.reason;
    }
    tally.cuts += reached ? 1 : 0;
    ++tally.statuses[std::string(toString(result.status)) + " (of " + toString(whole.status) + ")"];
  }
}

TEST(MatchCuts, GiveNoVerdictThatTheWholeMatchDoesNotGive) {
  Tally tally;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const std::string name = "seed " + std::to_string(seed);
    RepeatedRoom room(seed);
    room.options.threads = 1 + static_cast<int>(seed % 3) / 2;
    MatchPrior prior;
    if (seed % 4 == 1) {
      prior.alignment = room.match({}, work::Deadline()).T_reference_session;
    } else if (seed % 4 == 2) {
      prior.alignment = grid::Rigid2{2.0, 1.0, 0.5};
    }

    cutEverywhere(room, prior, seed % 5 == 4 ? test::Cut::Kind::kStop : test::Cut::Kind::kDeadline, name, tally);
  }
  std::cout << tally << '\n';
  EXPECT_GT(tally.cuts, 1000);
  EXPECT_TRUE(tally.flawless()) << tally;
}

}  // namespace
}  // namespace map_matcher::search
