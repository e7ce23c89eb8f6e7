#include "map_matcher/ros/scrubbing/scrubber_diagnostics.hpp"

#include <ros/time.h>

#include "map_matcher/ros/common/detection_messages.hpp"

namespace map_matcher::ros_scrubbing {
namespace {

using ros_common::diagnostics::kError;
using ros_common::diagnostics::kOk;
using ros_common::diagnostics::kWarn;

constexpr double kScanSilence = 2.0;  // [s] without a scan that is an error

std::int64_t countOf(const ScanRecord& record, scrubbing::PosePath path) {
  return record.paths[static_cast<std::size_t>(path)];
}

}  // namespace

ScrubberDiagnostics::ScrubberDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                         const ScrubberState& state)
    : state_(state), report_(node, private_node, [this] {
        last_ = now_;
        now_ = state_.scans;
        now_.failures = state_.guard.failures();
      }) {
  report_.add("scans", [this](Status& status) { reportScans(status); });
  report_.add("scrubbing", [this](Status& status) { reportScrubbing(status); });
  if (state_.veto.isAskedFor()) {
    report_.add("wall veto", [this](Status& status) { reportVeto(status); });
  }
  for (const auto& entry : state_.detectors.records()) {
    const std::string& topic = entry.first;
    report_.add("detections " + topic, [this, topic](Status& status) { reportDetector(topic, status); });
  }
}

double ScrubberDiagnostics::Rate::update(std::int64_t new_count) {
  const ros::WallTime now = ros::WallTime::now();
  const double elapsed = (now - time).toSec();
  const double rate = elapsed > 0.0 ? static_cast<double>(new_count - count) / elapsed : 0.0;
  count = new_count;
  time = now;
  return rate;
}

void ScrubberDiagnostics::reportScans(Status& status) {
  const double silence = scrubbing::seconds(ros_common::rosNow() - now_.last_scan);
  if (now_.last_scan == scrubbing::Stamp(0)) {
    status.summary(kWarn, "no scan yet");
  } else if (silence > kScanSilence) {
    status.summaryf(kError, "no scan for %.1f s", silence);
  } else if (now_.failures > last_.failures) {
    status.summary(kError, "failed: " + state_.guard.lastFailure());
  } else if (now_.dropped > last_.dropped) {
    status.summary(kError, "scans dropped: " + now_.last_problem);
  } else if (now_.withheld > last_.withheld) {
    status.summary(kError, "scans withheld, since people might be in them");
  } else {
    status.summary(kOk, "scans arrive");
  }
  status.addf("rate [Hz]", "%.1f", scan_rate_.update(now_.scans));
  status.add("scans", now_.scans);
  status.add("dropped", now_.dropped);
  status.add("withheld", now_.withheld);
  status.add("waited in vain for detections", now_.timed_out);
  status.add("last problem", now_.last_problem);
  status.add("failures", now_.failures);
  status.add("last failure", state_.guard.lastFailure());
}

void ScrubberDiagnostics::reportScrubbing(Status& status) {
  summarizeScrubbing(status);
  status.add("removed beams, last scan", now_.last_removed);
  status.add("removed beams", now_.removed_beams);
  status.add("scans passed as they were", now_.too_much);
  for (const scrubbing::PosePath path : {scrubbing::PosePath::kFixedFrame, scrubbing::PosePath::kNewest,
                                         scrubbing::PosePath::kSensorFrame, scrubbing::PosePath::kNone}) {
    status.add(std::string("detections placed: ") + toString(path), countOf(now_, path));
  }
}

/// The worst that is so; what the detectors lack is told by each of them, too.
void ScrubberDiagnostics::summarizeScrubbing(Status& status) const {
  const auto more = [this](scrubbing::PosePath path) { return countOf(now_, path) > countOf(last_, path); };
  status.summary(kOk, "people are removed where they are");
  if (now_.scans == last_.scans) {
    status.mergeSummary(kWarn, "no scan since the last report");
  }
  if (now_.too_much > last_.too_much) {
    status.mergeSummary(kError, "scans passed as they were: more than max_removed_fraction would have been removed");
  }
  if (more(scrubbing::PosePath::kNone)) {
    status.mergeSummary(kError, "detections not used: tf does not connect their frame with the scan's");
  } else if (more(scrubbing::PosePath::kSensorFrame)) {
    status.mergeSummary(kWarn, "detections used as if the robot stood still: tf does not know how it moved");
  }
  for (const auto& [topic, record] : state_.detectors.records()) {
    Status detector;
    summarizeDetector(record, detector);
    if (detector.level != kOk) {
      status.mergeSummary(static_cast<unsigned char>(detector.level), topic + " " + detector.message);
    }
  }
}

void ScrubberDiagnostics::reportVeto(Status& status) const {
  if (!state_.veto.hasMap()) {
    status.summary(kWarn, "off: no reference map yet");
  } else if (now_.without_veto > last_.without_veto) {
    status.summary(kWarn, "off: tf does not tell where the detections were in the reference map");
  } else if (now_.with_veto == last_.with_veto) {
    status.summary(kWarn, "no detections since the last report");
  } else {
    status.summary(kOk, "detections on walls are left out");
  }
  status.add("messages compared with the map", now_.with_veto);
  status.add("messages not compared", now_.without_veto);
  status.add("dropped maps", state_.veto.droppedMaps());
}

void ScrubberDiagnostics::reportDetector(const std::string& topic, Status& status) {
  const scrubbing::DetectorRecord& record = state_.detectors.records().at(topic);
  summarizeDetector(record, status);
  status.addf("rate [Hz]", "%.1f", detector_rates_[topic].update(record.messages));
  status.addf("silent for [s]", "%.2f", state_.detectors.silence(record, ros_common::rosNow()));
  status.addf("behind the scans [s]", "%.3f", record.last_delay);
  status.add("messages", record.messages);
  status.add("detections used", record.detections);
  status.add("detections left out", record.left_out);
  status.add("detections on walls", record.on_walls);
  status.add("bad messages", record.bad_messages);
  status.add("last problem", record.last_problem);
}

void ScrubberDiagnostics::summarizeDetector(const scrubbing::DetectorRecord& record, Status& status) const {
  const scrubbing::Stamp now = ros_common::rosNow();
  const double silence = state_.detectors.silence(record, now);
  const bool is_heard = record.last_heard != scrubbing::Stamp(0);
  switch (state_.detectors.health(record, now)) {
    case scrubbing::DetectorHealth::kAlive:
      if (is_heard && pathOf(record) == scrubbing::PosePath::kNone) {
        status.summary(kError, "not used: tf does not connect its frame " + record.frame + " with the scans' frame " +
                                   state_.removal.scanFrame());
      } else {
        status.summary(is_heard ? kOk : kWarn, is_heard ? "alive" : "nothing heard yet");
      }
      break;
    case scrubbing::DetectorHealth::kQuiet:
      status.summaryf(kWarn, "silent for %.1f s", silence);
      break;
    case scrubbing::DetectorHealth::kSilent:
      status.summaryf(kError, "silent for %.1f s", silence);
      break;
    case scrubbing::DetectorHealth::kTooLate:
      status.summaryf(kError, "%.2f s behind the scans: too late for all of them, so that nothing is removed",
                      record.last_delay);
  }
}

/// The way that its last message, even an empty one, takes into the scans' frame; nothing before there is a scan.
std::optional<scrubbing::PosePath> ScrubberDiagnostics::pathOf(const scrubbing::DetectorRecord& record) const {
  return state_.removal.pathFrom({record.frame, record.stamp});
}

}  // namespace map_matcher::ros_scrubbing
