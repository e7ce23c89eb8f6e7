#include "map_matcher/ros/waiting_scans.hpp"

#include <algorithm>

#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_messages.hpp"

namespace map_matcher {
namespace {

constexpr std::size_t kMaxWaiting = 100;   // the oldest goes when there are more
constexpr std::size_t kAnswersKept = 100;  // of all detectors

}  // namespace

void WaitingScans::add(const sensor_msgs::LaserScanConstPtr& scan, ros::SteadyTime now) {
  waiting_.push_back({scan, now + timeout_});
}

void WaitingScans::onDetections(const std::string& frame, Stamp stamp) {
  answers_.push_back({frame, stamp});
  if (answers_.size() > kAnswersKept) {
    answers_.pop_front();
  }
}

std::vector<WaitingScans::Released> WaitingScans::release(ros::SteadyTime now) {
  std::vector<Released> released;
  while (!waiting_.empty()) {
    const Waiting& next = waiting_.front();
    const bool answered = isAnswered(*next.scan);
    if (!answered && now < next.deadline && waiting_.size() <= kMaxWaiting) {
      break;
    }
    released.push_back({next.scan, answered});
    waiting_.pop_front();
  }
  return released;
}

bool WaitingScans::isAnswered(const sensor_msgs::LaserScan& scan) const {
  const std::string frame = frameName(scan.header.frame_id);
  const Stamp stamp = stampOf(scan.header.stamp);
  return std::any_of(answers_.rbegin(), answers_.rend(),
                     [&](const Answer& answer) { return answer.stamp == stamp && answer.frame == frame; });
}

}  // namespace map_matcher
