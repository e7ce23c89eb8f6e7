#include "map_matcher/ros/matching/match_diagnostics.hpp"

#include <string>
#include <utility>

#include "map_matcher/ros/common/diagnostic_levels.hpp"
#include "map_matcher/ros/matching/session_map.hpp"

namespace map_matcher::ros_matching {
namespace {

using diagnostic_updater::DiagnosticStatusWrapper;
using ros_common::diagnostics::kError;
using ros_common::diagnostics::kOk;
using ros_common::diagnostics::kWarn;

const ros::WallDuration kReportPeriod(1.0);

/// Whether the report says that something is wrong, and not only that more has to be seen.
bool isError(const MapMatch& report) {
  return report.status == MapMatch::EQUAL_FRAMES || report.status == MapMatch::ROBOT_LOST ||
         report.status == MapMatch::FAILED;
}

double ageOf(const ros::Time& time) { return (ros::Time::now() - time).toSec(); }

}  // namespace

void MatchRecord::add(const MapMatch& report) {
  last_report = report;
  if (report.status == MapMatch::MATCHED) {
    last_match = report;
    new_session.clear();
    reports_since = 0;
    return;
  }
  ++reports_since;
}

void MatchRecord::forgetMatch() {
  last_report.reset();
  last_match.reset();
  reports_since = 0;
}

MatchDiagnostics::MatchDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                   std::function<State()> state, const std::string& session_topic,
                                   const std::string& reference_topic)
    : look_(std::move(state)),
      session_topic_(session_topic),
      reference_topic_(reference_topic),
      updater_(node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  updater_.add("reference map", [this](DiagnosticStatusWrapper& status) { reportReference(status); });
  updater_.add("session maps", [this](DiagnosticStatusWrapper& status) { reportSession(status); });
  updater_.add("alignment", [this](DiagnosticStatusWrapper& status) { reportAlignment(status); });
  timer_ = node.createWallTimer(kReportPeriod, [this](const ros::WallTimerEvent& /*event*/) {
    state_ = look_();
    updater_.force_update();
  });
}

void MatchDiagnostics::reportReference(DiagnosticStatusWrapper& status) const {
  if (state_.references.empty()) {
    status.summary(kWarn, "no reference map yet on " + reference_topic_);
    return;
  }
  status.summary(kOk, state_.references.size() == 1 ? "in use" : std::to_string(state_.references.size()) + " in use");
  for (const ReferenceMapPtr& reference : state_.references) {
    const grid::OccupancyGrid& grid = reference->map.grid();
    status.add("frame", reference->frame);
    status.addf("size [cells]", "%d x %d", grid.width(), grid.height());
    status.addf("resolution [m]", "%g", grid.resolution());
  }
  status.add("dropped", state_.dropped_reference_maps);
}

void MatchDiagnostics::reportSession(DiagnosticStatusWrapper& status) const {
  const MatchRecord& record = state_.record;
  if (!record.last_session_map) {
    status.summary(kWarn, "no session map yet on " + session_topic_);
    return;
  }
  if (record.last_report && isUnusable(*record.last_report)) {
    status.summary(kWarn, "the last one was dropped: " + record.last_report->reason);
  } else {
    status.summary(kOk, "arrive");
  }
  status.add("session maps", record.session_maps);
  status.addf("last one, ago [s]", "%.1f", ageOf(*record.last_session_map));
  status.add("dropped", state_.dropped_session_maps);
  if (record.last_report) {
    status.addf("last search [s]", "%.3f", record.last_report->search_time);
  }
}

void MatchDiagnostics::reportAlignment(DiagnosticStatusWrapper& status) const {
  const MatchRecord& record = state_.record;
  const std::optional<MapMatch>& match = record.last_match;
  const std::string reason = record.last_report ? record.last_report->reason : "";
  if (record.last_report && isError(*record.last_report)) {
    status.summary(kError, (match ? "that of an earlier map is on tf, but: " : "none: ") + reason);
  } else if (!match) {
    const std::string since =
        record.new_session.empty() ? "" : " in the new session, which began since " + record.new_session;
    status.summary(kWarn, "none yet" + since + (reason.empty() ? "" : ": " + reason));
  } else if (state_.contested) {
    status.summary(kError, "not on tf: another node gives the child frame a parent");
  } else if (record.reports_since > 0) {
    status.summaryf(kWarn, "that of %.1f s ago; no map has matched since: %s", ageOf(match->header.stamp),
                    reason.c_str());
  } else if (!record.robot_unknown.empty()) {
    status.summary(kWarn, "that of the last map, but whether the mapper has lost the robot is not checked: " +
                              record.robot_unknown);
  } else {
    status.summary(kOk, "that of the last map");
  }
  if (record.last_report) {
    status.add("last status", record.last_report->status_text);
    status.add("state", record.last_report->state_text);
  }
  if (match) {
    status.add("reference frame", match->reference_frame);
    status.addf("x, y [m], yaw [rad]", "%.3f, %.3f, %.4f", match->x, match->y, match->yaw);
    status.addf("ratio", "%.3f", match->ratio);
    status.addf("hit ratio", "%.3f", match->hit_ratio);
    status.addf("margin", "%.3f", match->margin);
    status.addf("probability", "%.4f", match->probability);
    status.add("maps since the last proof", match->maps_since_proof);
    status.add("searches since", record.reports_since);
  }
}

}  // namespace map_matcher::ros_matching
