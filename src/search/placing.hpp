/// \file
/// From poses in whole cells to places in the reference map.
#pragma once

#include <cstdint>

#include "map_matcher/search/counting/session_cells.hpp"
#include "map_matcher/search/exact/rotation_blocks.hpp"
#include "map_matcher/search/search_frames.hpp"
#include "map_matcher/search/search_options.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/search_result.hpp"
#include "map_matcher/search/search_session.hpp"
#include "map_matcher/search/two_stage/branch_and_bound.hpp"

namespace map_matcher::search {

/// Tells what a pose of a session's cells means for its map. All that it is given has to outlive it.
class Placing {
 public:
  /// `rotations` are those that the poses count.
  Placing(const SearchReference& reference, const SearchSession& session, const SearchOptions& options,
          const RotationBlocks& rotations)
      : reference_(reference),
        cells_(session.fine),
        hit_tolerance_(options.hit_tolerance),
        rotations_(rotations),
        frames_(reference.T_reference_grid(), session.T_session_grid) {}

  /// The place of a pose, moved to where the session lies best; it is worth its hit ratio.
  Place placeOf(const SearchPose& pose) const;

  /// T_reference_session at a pose.
  grid::Rigid2 mapPose(const SearchPose& pose) const { return frames_.mapPose(centrePose(pose), cells_.centre); }

  CentrePose centrePose(const SearchPose& pose) const;

  /// The strict count at a pose, of session cells whose centres fall into walls.
  int matchesAt(const CentrePose& pose) const;

  double ratio(int count) const { return static_cast<double>(count) / rotations_.numCells(); }

 private:
  const SearchReference& reference_;
  const SessionCells& cells_;
  double hit_tolerance_;  // [m]
  const RotationBlocks& rotations_;
  SearchFrames frames_;
};

}  // namespace map_matcher::search
