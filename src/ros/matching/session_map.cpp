#include "map_matcher/ros/matching/session_map.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/matching/match_messages.hpp"

namespace map_matcher::ros_matching {

SessionMapPtr sessionMapOf(const nav_msgs::OccupancyGrid& message) {
  std::string frame = ros_common::frameOf(message.header);
  return std::make_shared<const SessionMap>(
      SessionMap{ros_common::fromMessage(message), std::move(frame), message.header.stamp});
}

belief::SessionMapTraits traitsOf(const SessionMap& session, const std::string& publisher) {
  const std::vector<std::int8_t>& values = session.grid.values();
  belief::SessionMapTraits traits;
  traits.frame = session.frame;
  traits.publisher = publisher;
  if (!session.stamp.isZero()) {
    traits.stamp = session.stamp.toSec();
  }
  traits.resolution = session.grid.resolution();
  traits.known_cells = std::count_if(values.begin(), values.end(), [](std::int8_t value) { return value >= 0; });
  return traits;
}

MapMatch noReferenceReport() {
  belief::Answer none;
  none.status = belief::MatchStatus::kNoReference;
  none.reason = "there is no reference map yet";
  return toMessage(none);
}

std::optional<MapMatch> refuseEqualFrames(const ReferenceMapList& references, const SessionMap& session) {
  if (findFrame(references, session.frame) == references.end()) {
    return std::nullopt;
  }
  return refusal(
      MapMatch::EQUAL_FRAMES,
      "the session map and the reference map are both in the frame \"" + session.frame +
          "\", expected two: let the mapper use another one (slam_gmapping: _map_frame:=session_map) or, for "
          "a map read from a file, set ~reference_frame");
}

ReferenceMapPtr referenceOf(const belief::Answer& answer, const ReferenceMapList& references) {
  return answer.search.found ? references.at(answer.map) : onlyOne(references);
}

MapMatch matchMessage(const belief::MatchOptions& options, const ReferenceMapList& references,
                      const nav_msgs::OccupancyGrid& session, const search::Constraints& constraints,
                      const work::StopToken& stop) {
  MapMatch report = noReferenceReport();
  ReferenceMapPtr reference = onlyOne(references);
  try {
    const SessionMapPtr map = sessionMapOf(session);
    if (!references.empty()) {
      const belief::Answer answer = belief::matchAlone(searched(references), map->grid, options, constraints, stop);
      report = toMessage(answer);
      reference = referenceOf(answer, references);
    }
  } catch (const ros_common::MessageError& error) {
    report = refusal(MapMatch::INVALID_MAP, error.what());
  }
  fillFrames(report, reference, ros_common::frameName(session.header.frame_id), session.header.stamp);
  return report;
}

void fillFrames(MapMatch& report, const ReferenceMapPtr& reference, const std::string& session_frame,
                const ros::Time& session_stamp) {
  report.reference_frame = reference ? reference->frame : "";
  report.header.frame_id = report.reference_frame;
  report.session_frame = session_frame;
  report.session_stamp = session_stamp;
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
