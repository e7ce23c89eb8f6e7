#include "map_matcher/scrubbing/waiting_scans.hpp"

#include <algorithm>
#include <utility>

namespace map_matcher::scrubbing {
namespace {

constexpr std::size_t kMaxWaiting = 100;   // the oldest goes when there are more
constexpr std::size_t kAnswersKept = 100;  // of all detectors

}  // namespace

void WaitingScans::add(RawScan scan, Stamp now, HandOn hand_on) {
  waiting_.push_back({std::move(scan), std::move(hand_on), now + timeout_});
}

void WaitingScans::onDetections(const std::string& frame, Stamp stamp) {
  answers_.push_back({frame, stamp});
  if (answers_.size() > kAnswersKept) {
    answers_.pop_front();
  }
}

std::optional<WaitingScans::Released> WaitingScans::release(Stamp now) {
  if (waiting_.empty()) {
    return std::nullopt;
  }
  Waiting& next = waiting_.front();
  const bool answered = isAnswered(next.scan);
  if (!answered && now < next.deadline && waiting_.size() <= kMaxWaiting) {
    return std::nullopt;
  }
  Released released{std::move(next.scan), std::move(next.hand_on), answered};
  waiting_.pop_front();
  return released;
}

bool WaitingScans::isAnswered(const RawScan& scan) const {
  return std::any_of(answers_.rbegin(), answers_.rend(), [&scan](const Answer& answer) {
    return answer.stamp == scan.stamp && answer.frame == scan.frame;
  });
}

}  // namespace map_matcher::scrubbing
