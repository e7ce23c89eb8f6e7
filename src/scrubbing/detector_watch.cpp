#include "map_matcher/scrubbing/detector_watch.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::scrubbing {

DetectorWatch::DetectorWatch(const std::vector<std::string>& topics, const DetectorLimits& limits) : limits_(limits) {
  for (const std::string& topic : topics) {
    records_[topic];
  }
}

void DetectorWatch::restart(Stamp now) {
  start_ = now;
  for (auto& [topic, record] : records_) {
    record.last_heard = Stamp(0);
    record.has_served = false;
    record.last_has_served = false;
    record.useless_since.reset();
  }
}

void DetectorWatch::onDetections(const DetectionSet& set, Stamp now) {
  DetectorRecord& detector = record(set.source);
  if (silence(detector, now) > limits_.silence_error) {
    detector.useless_since.reset();  // it was silent in between
  }
  ++detector.messages;
  detector.last_heard = now;
  detector.frame = set.frame;
  detector.stamp = set.stamp;
  detector.last_has_served = false;
}

void DetectorWatch::onScan(Stamp scan_stamp, Stamp now) {
  for (auto& [topic, record] : records_) {
    if (record.last_heard == Stamp(0)) {
      continue;
    }
    if (std::abs(seconds(scan_stamp - record.stamp)) <= limits_.cache_duration) {
      record.has_served = true;
      record.last_has_served = true;
      record.useless_since.reset();
    } else if (!record.last_has_served && !record.useless_since) {
      record.useless_since = now;
    }
  }
}

double DetectorWatch::silence(const DetectorRecord& record, Stamp now) const {
  const Stamp since = record.last_heard == Stamp(0) ? start_ : record.last_heard;
  return since == Stamp(0) ? 0.0 : std::max(0.0, seconds(now - since));
}

double DetectorWatch::lateness(const DetectorRecord& record, Stamp now) {
  return record.useless_since ? std::max(0.0, seconds(now - *record.useless_since)) : 0.0;
}

DetectorHealth DetectorWatch::health(const DetectorRecord& record, Stamp now) const {
  const double silent_for = silence(record, now);
  if (silent_for > limits_.silence_error) {
    return DetectorHealth::kSilent;
  }
  if (silent_for > limits_.silence_warning) {
    return DetectorHealth::kQuiet;
  }
  return lateness(record, now) > limits_.silence_warning ? DetectorHealth::kTooLate : DetectorHealth::kAlive;
}

std::vector<std::string> DetectorWatch::uselessTopics(Stamp now) const {
  std::vector<std::string> topics;
  for (const auto& [topic, record] : records_) {
    if (!record.has_served || health(record, now) == DetectorHealth::kSilent ||
        lateness(record, now) > limits_.silence_error) {
      topics.push_back(topic);
    }
  }
  return topics;
}

}  // namespace map_matcher::scrubbing
