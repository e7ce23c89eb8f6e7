/// \file
/// Matching map messages to the reference map in use.
#pragma once

#include <map_matcher/MapMatch.h>
#include <nav_msgs/OccupancyGrid.h>

#include <optional>

#include "map_matcher/ros/matching/reference_map.hpp"
#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/search/matched_cells.hpp"

namespace map_matcher::ros_matching {

/// What came of a session map.
struct SessionMatch {
  MapMatch report;             ///< Without the stamp of its header and its counts.
  search::MatchResult result;  ///< What the report is made from; not that of a search when the map is invalid.
  double resolution = 0.0;     ///< Edge length of the session map's cells [m]; 0 when the map is invalid.
  search::MatchedCells cells;  ///< Of the session map, at the pose of the report; empty unless matched.
};

/// A MapMatcher that follows the reference map in use. Not thread-safe.
class ReferenceMatcher {
 public:
  /// Throws std::invalid_argument that names every option out of range.
  explicit ReferenceMatcher(const search::MatchOptions& options) : matcher_(options) {}

  const search::MatchOptions& options() const { return matcher_.options(); }

  /// Matches `session` to `reference`, which may be null. Never throws on account of the message: one that cannot be
  /// used is a report with status INVALID_MAP.
  SessionMatch match(const ReferenceMapPtr& reference, const nav_msgs::OccupancyGrid& session,
                     const search::MatchPrior& prior = {}, const work::StopToken& stop = {});

 private:
  search::MatchResult search(const ReferenceMapPtr& reference, const grid::OccupancyGrid& session,
                             const search::MatchPrior& prior, const work::StopToken& stop);

  search::MapMatcher matcher_;
  ReferenceMapPtr reference_;  // the one that matcher_ has
};

/// As ReferenceMatcher::match, for a session map whose pose is to be broadcast: refuses, with status EQUAL_FRAMES and
/// advice, maps in the frame of the reference map.
SessionMatch matchForBroadcast(ReferenceMatcher& matcher, const ReferenceMapPtr& reference,
                               const nav_msgs::OccupancyGrid& session, const search::MatchPrior& prior,
                               const work::StopToken& stop);

/// Whether the report is about a map that no search can use, whatever the reference map.
bool isUnusable(const MapMatch& report);

}  // namespace map_matcher::ros_matching
