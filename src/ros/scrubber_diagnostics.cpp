#include "map_matcher/ros/scrubber_diagnostics.hpp"

#include "map_matcher/ros/diagnostic_levels.hpp"

namespace map_matcher {
namespace {

using diagnostic_updater::DiagnosticStatusWrapper;
using diagnostics::kError;
using diagnostics::kOk;
using diagnostics::kWarn;

constexpr double kScanSilence = 2.0;  // [s] without a scan that is an error
const ros::WallDuration kReportPeriod(1.0);

std::int64_t countOf(const ScanRecord& record, PosePath path) { return record.paths[static_cast<std::size_t>(path)]; }

}  // namespace

ScrubberDiagnostics::ScrubberDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                         const ScanRecord& scans, const DetectorWatch& detectors)
    : scans_(scans), detectors_(detectors), updater_(node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  updater_.add("scans", [this](DiagnosticStatusWrapper& status) { reportScans(status); });
  updater_.add("scrubbing", [this](DiagnosticStatusWrapper& status) { reportScrubbing(status); });
  for (const auto& entry : detectors_.records()) {
    const std::string& topic = entry.first;
    updater_.add("detections " + topic,
                 [this, topic](DiagnosticStatusWrapper& status) { reportDetector(topic, status); });
  }
  timer_ =
      node.createWallTimer(kReportPeriod, [this](const ros::WallTimerEvent& /*event*/) { updater_.force_update(); });
}

double ScrubberDiagnostics::Rate::update(std::int64_t new_count) {
  const ros::WallTime now = ros::WallTime::now();
  const double elapsed = (now - time).toSec();
  const double rate = elapsed > 0.0 ? static_cast<double>(new_count - count) / elapsed : 0.0;
  count = new_count;
  time = now;
  return rate;
}

void ScrubberDiagnostics::reportScans(DiagnosticStatusWrapper& status) {
  const ros::Time now = ros::Time::now();
  if (scans_.last_scan.isZero()) {
    status.summary(kWarn, "no scan yet");
  } else if ((now - scans_.last_scan).toSec() > kScanSilence) {
    status.summaryf(kError, "no scan for %.1f s", (now - scans_.last_scan).toSec());
  } else if (scans_.dropped > last_scans_.dropped) {
    status.summary(kError, "scans dropped: " + scans_.last_problem);
  } else if (scans_.withheld > last_scans_.withheld) {
    status.summary(kError, "scans withheld, since a detector is silent");
  } else {
    status.summary(kOk, "scans arrive");
  }
  status.addf("rate [Hz]", "%.1f", scan_rate_.update(scans_.scans));
  status.add("scans", scans_.scans);
  status.add("dropped", scans_.dropped);
  status.add("withheld", scans_.withheld);
  status.add("waited in vain for detections", scans_.timed_out);
}

void ScrubberDiagnostics::reportScrubbing(DiagnosticStatusWrapper& status) {
  const auto more = [this](PosePath path) { return countOf(scans_, path) > countOf(last_scans_, path); };
  if (scans_.too_much > last_scans_.too_much) {
    status.summary(kError, "scans passed as they were: more than max_removed_fraction would have been removed");
  } else if (more(PosePath::kNone)) {
    status.summary(kError, "detections not used: tf does not connect their frame with the scan's");
  } else if (more(PosePath::kSensorFrame)) {
    status.summary(kWarn, "detections used as if the robot stood still: tf does not know how it moved");
  } else {
    status.summary(kOk, "people are removed where they are");
  }
  status.add("removed beams, last scan", scans_.last_removed);
  status.add("removed beams", scans_.removed_beams);
  status.add("scans passed as they were", scans_.too_much);
  for (const PosePath path : {PosePath::kFixedFrame, PosePath::kNewest, PosePath::kSensorFrame, PosePath::kNone}) {
    status.add(std::string("detections placed: ") + toString(path), countOf(scans_, path));
  }
  last_scans_ = scans_;
}

void ScrubberDiagnostics::reportDetector(const std::string& topic, DiagnosticStatusWrapper& status) {
  const DetectorRecord& record = detectors_.records().at(topic);
  const ros::Time now = ros::Time::now();
  const double silence = detectors_.silence(record, now);
  switch (detectors_.health(record, now)) {
    case DetectorHealth::kAlive:
      status.summary(record.last_heard.isZero() ? kWarn : kOk,
                     record.last_heard.isZero() ? "nothing heard yet" : "alive");
      break;
    case DetectorHealth::kQuiet:
      status.summaryf(kWarn, "silent for %.1f s", silence);
      break;
    case DetectorHealth::kSilent:
      status.summaryf(kError, "silent for %.1f s", silence);
      break;
    case DetectorHealth::kTooLate:
      status.summaryf(kError, "%.2f s behind the scans: later than cache_duration, so that nothing is removed",
                      record.last_delay);
  }
  status.addf("rate [Hz]", "%.1f", detector_rates_[topic].update(record.messages));
  status.addf("silent for [s]", "%.2f", silence);
  status.addf("behind the scans [s]", "%.3f", record.last_delay);
  status.add("messages", record.messages);
  status.add("detections used", record.detections);
  status.add("detections left out", record.left_out);
  status.add("detections on walls", record.on_walls);
  status.add("bad messages", record.bad_messages);
  status.add("last problem", record.last_problem);
}

}  // namespace map_matcher
