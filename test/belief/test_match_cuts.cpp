// What a match says when it is cut, at every look at its deadline, held against the match that is not. The seeds are
// fixed and named in every failure.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <random>
#include <string>

#include "map_matcher/belief/single_match.hpp"
#include "support/cut.hpp"
#include "support/matcher.hpp"
#include "support/random_maps.hpp"
#include "support/repeated_rooms.hpp"

namespace map_matcher::belief {
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
    options.search.coarse_resolution = 0.2;
    options.search.hit_tolerance = random() % 2 == 0 ? 0.0 : 0.1;
    options.search.min_session_cells = 10;
    options.search.distinct_distance = 0.5;
    options.search.coarse.acceptance_ratio = 0.4;
    options.belief.min_hit_ratio = 0.5;
    options.belief.min_margin = 0.02 * static_cast<double>(random() % 8);
  }

  Answer match(const Circumstances& prior, const work::Deadline& deadline) const {
    const test::Matcher matcher(*reference, options);
    return matcher.match(*session, prior, deadline);
  }

  std::mt19937 random;
  std::unique_ptr<grid::OccupancyGrid> reference;
  std::unique_ptr<grid::OccupancyGrid> session;
  MatchOptions options;
  std::vector<KnownPlace> starts;
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
grid::Rigid2 wholeCells(const Answer& result) {
  return result.search.searched ? *result.search.searched : result.search.T_reference_session;
}

/// Adds what is wrong with a match that was cut to the tally. `whole` is the match that was not, and `truth` the same
/// with any share of hits and any margin, so that it has the best place elsewhere.
void check(const Answer& cut, const Answer& whole, const Answer& truth, Tally& tally) {
  constexpr double kRounding = 1e-9;
  const bool undecided = cut.status == MatchStatus::kNotCertified || cut.status == MatchStatus::kStopped;
  tally.wrong_verdicts += undecided || cut.status == whole.status ? 0 : 1;
  if (cut.matched()) {
    tally.wrong_poses += samePose(cut.search.T_reference_session, whole.search.T_reference_session) ? 0 : 1;
  }
  tally.wrong_bounds += cut.search.upper_bound < truth.search.hit_ratio - kRounding ? 1 : 0;
  if (cut.search.certified) {
    const bool found = whole.search.hit_cells > 0 && cut.search.hit_cells > 0;
    tally.wrong_poses += cut.search.hit_cells == whole.search.hit_cells && whole.search.certified ? 0 : 1;
    tally.wrong_poses += !found || samePose(wholeCells(cut), wholeCells(whole)) ? 0 : 1;
  }
  const double true_margin = truth.search.hit_ratio - (truth.search.runner_up ? truth.search.runner_up->ratio : 0.0);
  tally.wrong_margins += cut.search.margin > true_margin + kRounding ? 1 : 0;
  tally.wrong_margins +=
      cut.search.runner_up && cut.search.runner_up->ratio > truth.search.hit_ratio - true_margin + kRounding ? 1 : 0;
}

/// Cuts a match at every look until it ends by itself.
void cutEverywhere(const RepeatedRoom& room, const Circumstances& prior, test::Cut::Kind kind, const std::string& name,
                   Tally& tally) {
  const Answer whole = room.match(prior, work::Deadline());
  RepeatedRoom any = RepeatedRoom(0);
  any.reference = std::make_unique<grid::OccupancyGrid>(*room.reference);
  any.session = std::make_unique<grid::OccupancyGrid>(*room.session);
  any.options = room.options;
  any.options.belief.min_hit_ratio = any.options.search.coarse.acceptance_ratio = 0.2;
  any.options.belief.min_margin = 1.0;
  const Answer truth = any.match(prior, work::Deadline());
  const test::Matcher matcher(*room.reference, room.options);
  bool reached = true;
  for (long look = 1; reached; ++look) {
    const test::Cut cut(look, kind);
    const Answer result = matcher.match(*room.session, prior, cut.deadline(), room.starts);
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
    room.options.search.threads = 1 + static_cast<int>(seed % 3) / 2;
    Circumstances prior;
    if (seed % 4 == 1) {
      prior.alignment = room.match({}, work::Deadline()).search.T_reference_session;
    } else if (seed % 4 == 2) {
      prior.alignment = grid::Rigid2{2.0, 1.0, 0.5};
    }

    if (seed % 3 == 1) {  // where it is, where it is not, and where nothing is
      room.starts = {room.match({}, work::Deadline()).search.T_reference_session, grid::Rigid2{3.0, 2.0, -1.0},
                     grid::Rigid2{1e9, -1e9, 2.0}};
    }
    cutEverywhere(room, prior, seed % 5 == 4 ? test::Cut::Kind::kStop : test::Cut::Kind::kDeadline, name, tally);
  }
  std::cout << tally << '\n';
  EXPECT_GT(tally.cuts, 1000);
  EXPECT_TRUE(tally.flawless()) << tally;
}

}  // namespace
}  // namespace map_matcher::belief
