#include "map_matcher/ros/detector_watch.hpp"

#include <algorithm>

namespace map_matcher {

DetectorWatch::DetectorWatch(const std::vector<std::string>& topics, double silence_warning, double silence_error,
                             double cache_duration)
    : silence_warning_(silence_warning), silence_error_(silence_error), cache_duration_(cache_duration) {
  for (const std::string& topic : topics) {
    records_[topic];
  }
}

void DetectorWatch::restart(const ros::Time& now) {
  start_ = now;
  for (auto& [topic, record] : records_) {
    record.last_heard = ros::Time();
  }
}

double DetectorWatch::silence(const DetectorRecord& record, const ros::Time& now) const {
  const ros::Time since = record.last_heard.isZero() ? start_ : record.last_heard;
  return since.isZero() ? 0.0 : std::max(0.0, (now - since).toSec());
}

DetectorHealth DetectorWatch::health(const DetectorRecord& record, const ros::Time& now) const {
  const double silent_for = silence(record, now);
  if (silent_for > silence_error_) {
    return DetectorHealth::kSilent;
  }
  if (silent_for > silence_warning_) {
    return DetectorHealth::kQuiet;
  }
  return record.last_delay > cache_duration_ ? DetectorHealth::kTooLate : DetectorHealth::kAlive;
}

std::vector<std::string> DetectorWatch::silentTopics(const ros::Time& now) const {
  std::vector<std::string> topics;
  for (const auto& [topic, record] : records_) {
    if (health(record, now) == DetectorHealth::kSilent) {
      topics.push_back(topic);
    }
  }
  return topics;
}

bool DetectorWatch::allHeard() const {
  return std::all_of(records_.begin(), records_.end(),
                     [](const auto& entry) { return !entry.second.last_heard.isZero(); });
}

}  // namespace map_matcher
