#include "map_matcher/ros/matching/reference_matcher.hpp"

#include <cstdint>
#include <string>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/matching/match_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

/// Copies what is known about a match before its search.
void fillFrames(MapMatch& report, const ReferenceMapPtr& reference, const nav_msgs::OccupancyGrid& session) {
  report.reference_frame = reference ? reference->frame : "";
  report.header.frame_id = report.reference_frame;
  report.session_frame = ros_common::frameName(session.header.frame_id);
  report.session_stamp = session.header.stamp;
}

}  // namespace

search::MatchResult ReferenceMatcher::search(const ReferenceMapPtr& reference, const grid::OccupancyGrid& session,
                                             const search::MatchPrior& prior, const work::StopToken& stop) {
  if (!reference) {
    search::MatchResult result;
    result.status = search::MatchStatus::kNoReference;
    result.reason = "there is no reference map yet";
    return result;
  }
  if (reference != reference_) {
    if (!matcher_.setReference(reference->grid, stop)) {
      search::MatchResult result;
      result.status = search::MatchStatus::kStopped;
      result.reason = "the search was stopped while the reference map was prepared";
      return result;
    }
    reference_ = reference;
  }
  return matcher_.match(session, prior, stop);
}

SessionMatch ReferenceMatcher::match(const ReferenceMapPtr& reference, const nav_msgs::OccupancyGrid& session,
                                     const search::MatchPrior& prior, const work::StopToken& stop) {
  SessionMatch match;
  try {
    ros_common::frameOf(session.header);
    const grid::OccupancyGrid grid = ros_common::fromMessage(session);
    match.result = search(reference, grid, prior, stop);
    match.report = toMessage(match.result);
    match.resolution = grid.resolution();
    if (match.result.matched()) {
      match.cells = search::splitByMatch(reference->grid, grid, match.result.T_reference_session, options());
    }
  } catch (const ros_common::MessageError& error) {
    match.report = refusal(MapMatch::INVALID_MAP, error.what());
  }
  fillFrames(match.report, reference, session);
  return match;
}

SessionMatch matchForBroadcast(ReferenceMatcher& matcher, const ReferenceMapPtr& reference,
                               const nav_msgs::OccupancyGrid& session, const search::MatchPrior& prior,
                               const work::StopToken& stop) {
  if (!reference || ros_common::frameName(session.header.frame_id) != reference->frame) {
    return matcher.match(reference, session, prior, stop);
  }
  SessionMatch refused;
  refused.report = refusal(MapMatch::EQUAL_FRAMES,
                           "the session map and the reference map are both in the frame \"" + reference->frame +
                               "\", expected two: let the mapper use another one (slam_gmapping: _map_frame:="
                               "session_map) or, for a map read from a file, set ~reference_frame");
  fillFrames(refused.report, reference, session);
  return refused;
}

bool isUnusable(const MapMatch& report) {
  switch (report.status) {
    case MapMatch::TOO_FEW_SESSION_CELLS:
    case MapMatch::SESSION_TOO_LARGE:
    case MapMatch::INVALID_MAP:
    case MapMatch::EQUAL_FRAMES:
      return true;
    default:
      return false;
  }
}

}  // namespace map_matcher::ros_matching
