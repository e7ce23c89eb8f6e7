/// \file
/// Session maps as messages, and what is told of them.
#pragma once

#include <map_matcher/MapMatch.h>
#include <nav_msgs/OccupancyGrid.h>

#include <memory>
#include <optional>
#include <string>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/session_map_traits.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/ros/matching/reference_map.hpp"
#include "map_matcher/search/constraints.hpp"
#include "map_matcher/work/stop_token.hpp"

namespace map_matcher::ros_matching {

/// A session map as it came. Shared between threads, hence never changed.
struct SessionMap {
  grid::OccupancyGrid grid;
  std::string frame;  ///< Without a leading slash, not empty.
  ros::Time stamp;
};

using SessionMapPtr = std::shared_ptr<const SessionMap>;

/// Throws MessageError, with the field, its value and what was expected, when the map cannot be used.
SessionMapPtr sessionMapOf(const nav_msgs::OccupancyGrid& message);

/// What shows of which session a map is; `publisher` is the name of the node that sent it.
belief::SessionMapTraits traitsOf(const SessionMap& session, const std::string& publisher);

/// The answer while there is no reference map.
MapMatch noReferenceReport();

/// Why a session map cannot be aligned on tf with `references`: it is in the frame of one of them. Refuses with status
/// EQUAL_FRAMES and advice; nothing when it can.
std::optional<MapMatch> refuseEqualFrames(const ReferenceMapList& references, const SessionMap& session);

/// The reference map that an answer is about; null when there are several, and it is about none of them.
ReferenceMapPtr referenceOf(const belief::Answer& answer, const ReferenceMapList& references);

/// Searches and judges a session map on its own. Never throws on account of the message: one that cannot be used is a
/// report with status INVALID_MAP. Throws what a search throws.
MapMatch matchMessage(const belief::MatchOptions& options, const ReferenceMapList& references,
                      const nav_msgs::OccupancyGrid& session, const search::Constraints& constraints,
                      const work::StopToken& stop);

/// Writes into the report which maps it is about. `reference` may be null.
void fillFrames(MapMatch& report, const ReferenceMapPtr& reference, const std::string& session_frame,
                const ros::Time& session_stamp);

/// Whether the report is about a map that no search can use, whatever the reference map.
bool isUnusable(const MapMatch& report);

}  // namespace map_matcher::ros_matching
