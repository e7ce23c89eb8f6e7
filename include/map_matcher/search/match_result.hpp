/// \file
/// The answer of a match: a pose, or the reason why there is none, and what it took.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::search {

/// Outcome of a match.
enum class MatchStatus {
  kMatched,               ///< There is an acceptable pose.
  kBelowAcceptanceRatio,  ///< No pose reaches the acceptance ratio; with the exact search, that is proven.
  kNoReference,           ///< No reference map was set.
  kEmptyReference,        ///< The reference map has no occupied cell.
  kTooFewSessionCells,    ///< The session map has fewer than min_session_cells occupied cells.
  kSessionTooLarge,       ///< The session map is too large for the search's arithmetic.
  kStopped,               ///< The stop token was set before there was an answer.
  kNotCertified,          ///< The deadline came before the end of the search, or of its proof.
  kAmbiguous,             ///< A place elsewhere matches nearly as well.
  kUnconfirmed,           ///< The place is good enough, but another than that of an earlier map of the session.
  kRobotAstray,           ///< The map fits, but not where the robot is.
};

/// The status in snake_case, as JSON output and messages have it ("matched", "below_acceptance_ratio", ...).
const char* toString(MatchStatus status);

/// What one branch-and-bound stage did. The three times are those of the report's figure 9.
struct StageReport {
  std::string name;                      ///< "coarse", "fine" or "exact".
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
};

/// A place other than that of the answer: MatchOptions::distinct_distance or distinct_angle away from it.
struct RunnerUp {
  grid::Rigid2 T_reference_session;  ///< p_reference = T_reference_session * p_session.
  double ratio = 0.0;                ///< Its hits / session cells, to compare with MatchResult::hit_ratio.
};

/// How the two maps agree around the robot.
struct Surroundings {
  int cells = 0;             ///< Session cells there [cells].
  double ratio = 0.0;        ///< Share of them within hit_tolerance of a wall of the reference map.
  int walls = 0;             ///< Wall cells of the reference map there at which the session map is known [cells].
  double walls_ratio = 0.0;  ///< Share of them at which it has a wall, too.
};

/// The answer of MapMatcher::match.
struct MatchResult {
  MatchStatus status = MatchStatus::kNoReference;
  std::string reason;  ///< One sentence with the figures behind the status.
  /// p_reference = T_reference_session * p_session; valid when kMatched. When kNotCertified, kAmbiguous,
  /// kUnconfirmed or kRobotAstray: the best pose so far, not to be relied on.
  grid::Rigid2 T_reference_session;
  std::optional<grid::Rigid2> searched;  ///< The same in whole cells and rotation steps, before it was moved by less
                                         ///< than a cell to where it fits best; nothing unless that was done.
  /// Of (x, y, yaw) of T_reference_session [m, m, rad], when kMatched: from the curvature around the refined pose, or
  /// without exact search that of a cell and a rotation step. It holds what the drawing of both maps in cells leaves
  /// open, nothing of bent maps.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool refined = false;   ///< Whether the pose is of the map's own resolution; false: the coarse answer stands.
  int matched_cells = 0;  ///< Session cells on walls of the reference at the pose [cells].
  int total_cells = 0;    ///< Session cells looked at [cells].
  double ratio = 0.0;     ///< matched_cells / total_cells.

  /// Whether it is proven that no pose has more hits; when kBelowAcceptanceRatio, that none has enough of them. False
  /// without exact search.
  bool certified = false;
  bool replaced = false;  ///< Whether the exact search found a better place than the two stages.
  int hit_cells = 0;      ///< Session cells within hit_tolerance of a wall at the pose [cells]; 0 without exact search.
  double hit_ratio = 0.0;             ///< hit_cells / total_cells, which the exact search makes as large as can be.
  double upper_bound = 1.0;           ///< No pose has a larger hit ratio; equal to hit_ratio when kMatched.
  std::optional<RunnerUp> runner_up;  ///< The best place elsewhere that was found, unless it is worse by more than
                                      ///< min_margin; nothing unless certified.
  bool runner_up_proven = false;      ///< Whether it is proven that no place elsewhere has more hits than runner_up;
                                      ///< without one, that none comes within min_margin.
  double margin = 0.0;  ///< No place elsewhere has a hit ratio above hit_ratio - margin; equal to hit_ratio less that
                        ///< of the runner-up when that is proven, and 0 unless certified.

  Surroundings nearby;  ///< With MatchPrior::robot, of a map that fits; else without cells.

  std::vector<StageReport> stages;  ///< Coarse, fine, exact; empty when no stage ran.
  double search_time = 0.0;         ///< The whole match without reference_time [s].
  double reference_time = 0.0;      ///< Building what depends only on the reference map, done once for each [s].

  bool matched() const { return status == MatchStatus::kMatched; }
};

}  // namespace map_matcher::search
