/// \file
/// One session map and what the matcher made of it.
#pragma once

#include <optional>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/evaluation/trajectory_error.hpp"
#include "map_matcher/search/search_result.hpp"

namespace map_matcher::trials {

/// One session map, how it came to be and what the matcher made of it.
struct TrialQuery {
  double time = 0.0;         ///< Of the map [s].
  int drive = 0;             ///< Counts the drives from 0.
  int session = 0;           ///< Counts the sessions of all drives from 0.
  double session_age = 0.0;  ///< Since the session's first scan [s].
  double travelled = 0.0;    ///< In the session, by odometry [m].
  belief::Answer answer;
  grid::Rigid2 T_session_base;  ///< Where the mapper believes the robot to be in its map.
  std::optional<grid::Rigid2>
      true_alignment;                 ///< T_reference_session as of the session's first scan, where it is known.
  std::optional<grid::Rigid2> truth;  ///< T_reference_base, where it is known.
  int falsely_occupied = 0;           ///< Session cells in free space of the reference, at the matched pose [cells].
  int occupied = 0;                   ///< Occupied session cells [cells].

  /// T_reference_session by the match; nothing without one.
  std::optional<grid::Rigid2> alignment() const;
  /// T_reference_base by the match; nothing without one.
  std::optional<grid::Rigid2> estimate() const;
  /// Of the robot's pose; nothing when it or the truth is not known.
  std::optional<evaluation::PoseError> robotError() const;

  /// T_reference_session of the best place that was found, believed or not; nothing when there is none.
  std::optional<grid::Rigid2> candidate() const;
  /// How far off the robot's pose is with the candidate; nothing when it or the truth is not known.
  std::optional<evaluation::PoseError> candidateError() const;
  /// How far the middle of the session map is off with the candidate, by the true alignment; nothing as above. It knows
  /// nothing of a robot that the mapper has lost.
  std::optional<search::PlaceDifference> candidateMapError() const;
};

}  // namespace map_matcher::trials
