/// \file
/// What a search found, what is proven of it, and what it took. Geometry alone: whether it is to be believed is decided
/// in belief/.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::search {

/// How a search ended.
enum class SearchEnding {
  kSearched,            ///< There is an answer, or there is none to be had.
  kOutOfTime,           ///< The deadline came first. What was found and proven by then holds all the same.
  kStopped,             ///< The stop token was set first.
  kEmptyReference,      ///< The reference map has no occupied cell: nothing was searched.
  kTooFewSessionCells,  ///< The session map has fewer than min_session_cells occupied cells: nothing was searched.
  kSessionTooLarge,     ///< The session map is too large for the search's arithmetic: nothing was searched.
};

/// What one branch-and-bound stage did. The three times are those of the report's figure 9.
struct StageReport {
  std::string name;                      ///< "coarse", "fine", "exact" or "follow".
  bool answered = false;                 ///< Whether a pose reached the stage's acceptance ratio; exact: and is proven.
  double resolution = 0.0;               ///< Edge length of the stage's cells [m].
  int rotations = 0;                     ///< Rotations of the session map that were searched, eq. 4.3.
  double rotation_step = 0.0;            ///< Angle between two of them, eq. 4.2 [rad].
  int matched_cells = 0;                 ///< Session cells of the stage on walls at its best pose [cells]; exact: hits.
  int total_cells = 0;                   ///< Session cells of the stage [cells].
  double ratio = 0.0;                    ///< matched_cells / total_cells of the stage's best pose.
  std::int64_t nodes_scored = 0;         ///< Nodes whose score was computed.
  std::int64_t nodes_expanded = 0;       ///< Nodes whose children were made.
  double initialization_time = 0.0;      ///< Preparing the session cells and their rotations [s].
  double rotation_expansion_time = 0.0;  ///< Scoring the initial node list [s].
  double depth_first_search_time = 0.0;  ///< Algorithm 1 from line 11 on [s].

  double time() const { return initialization_time + rotation_expansion_time + depth_first_search_time; }  ///< [s]
};

/// A place other than that of the answer: SearchOptions::distinct_distance or distinct_angle away from it.
struct RunnerUp {
  grid::Rigid2 T_reference_session;  ///< p_reference = T_reference_session * p_session.
  double ratio = 0.0;                ///< Its hits / session cells, to compare with SearchResult::hit_ratio.
};

/// One of the distinct places that were found.
struct Place {
  grid::Rigid2 T_reference_session;  ///< Where it fits best, moved by less than a cell from:
  grid::Rigid2 searched;             ///< The same in whole cells and rotation steps.
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Zero();  ///< Of (x, y, yaw) of T_reference_session, as SearchResult::covariance.
  int matched_cells = 0;        ///< Session cells on walls of the reference at T_reference_session [cells].
  int hit_cells = 0;            ///< Session cells within hit_tolerance of a wall at `searched` [cells].
  double hit_ratio = 0.0;       ///< hit_cells / SearchResult::total_cells.
  double worth = 0.0;           ///< What Demand::worth says of it; without that, its hit ratio.
};

/// The answer of MapMatcher::match or MapMatcher::follow.
struct SearchResult {
  SearchEnding ending = SearchEnding::kSearched;
  std::string reason;  ///< One sentence: why nothing was searched, or what the two stages came to.
  bool found = false;  ///< Whether there is a pose, the best one so far; false: what is said of one below is void.

  /// p_reference = T_reference_session * p_session.
  grid::Rigid2 T_reference_session;
  std::optional<grid::Rigid2> searched;  ///< The same in whole cells and rotation steps, before it was moved by less
                                         ///< than a cell to where it fits best; nothing unless that was done.
  /// Of (x, y, yaw) of T_reference_session [m, m, rad]: from the curvature around the refined pose, or without that of
  /// a cell and a rotation step. It holds what the drawing of both maps in cells leaves open, nothing of bent maps.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool refined = false;   ///< Whether the pose is of the map's own resolution; false: the coarse answer stands.
  int matched_cells = 0;  ///< Session cells on walls of the reference at the pose [cells].
  int total_cells = 0;    ///< Session cells looked at [cells].
  double ratio = 0.0;     ///< matched_cells / total_cells.

  bool exact = false;      ///< Whether an exact search, or to follow a place, was asked for; what comes now is theirs.
  bool certified = false;  ///< Whether it is proven that no pose has more hits, or that none has as many as demanded.
  bool replaced = false;   ///< Whether the exact search found a better place than it began with.
  int hit_cells = 0;       ///< Session cells within hit_tolerance of a wall at the pose [cells].
  double hit_ratio = 0.0;  ///< hit_cells / total_cells, which the exact search makes as large as can be.
  double upper_bound = 1.0;           ///< No pose has a larger hit ratio; equal to hit_ratio of a pose when certified.
  std::optional<RunnerUp> runner_up;  ///< The best place elsewhere that was found, unless it is worse by more than
                                      ///< Demand::margin; nothing unless certified.
  bool runner_up_proven = false;      ///< Whether it is proven that no place elsewhere has more hits than runner_up;
                                      ///< without one, that none comes within Demand::margin.
  double margin = 0.0;  ///< No place elsewhere has a hit ratio above hit_ratio - margin; equal to hit_ratio less that
                        ///< of the runner-up when that is proven, and 0 unless certified.
  /// The distinct places that were found, most hits first: the best pose of all, then the best one that is
  /// distinct_distance or distinct_angle away from it, then the best one so far away from both, and so on, until no
  /// other can be worth more than the one worth most less Demand::margin, or none reaches Demand::min_hit_ratio, or
  /// there are as many as demanded. When the time was over before that, the last one is the best so far.
  std::vector<Place> places;
  double elsewhere_bound = 1.0;  ///< No pose that is so far away from every one of `places` has a larger hit ratio.
                                 ///< That is proven, whatever ended the search.
  /// The middle of the session's cells, where distances between places are measured [m, session map frame].
  Eigen::Vector2d session_centre{0.0, 0.0};

  std::vector<StageReport> stages;  ///< Coarse, fine, exact, or follow alone; empty when no stage ran.
  double search_time = 0.0;         ///< The whole search without reference_time [s].
  double reference_time = 0.0;      ///< Building what depends only on the reference map, done once for each [s].

  /// Whether a search took place, with or without an answer.
  bool ended() const { return ending == SearchEnding::kSearched || ending == SearchEnding::kOutOfTime; }
};

/// Makes a place, with all that is known of it, the answer. `result.total_cells` is set.
void setAnswer(SearchResult& result, const Place& place);

/// The stage called `name`; nullptr when it did not run.
const StageReport* stageOf(const SearchResult& result, const std::string& name);

/// How far apart two places of a session map are.
struct PlaceDifference {
  double distance = 0.0;  ///< Between the two places of its middle [m].
  double angle = 0.0;     ///< Between the two headings [rad], 0 to pi.
};

/// `session_centre` [m, session map frame] is SearchResult::session_centre.
PlaceDifference difference(const grid::Rigid2& T_a_session, const grid::Rigid2& T_b_session,
                           const Eigen::Vector2d& session_centre);

}  // namespace map_matcher::search
