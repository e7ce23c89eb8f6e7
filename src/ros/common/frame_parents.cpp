#include "map_matcher/ros/common/frame_parents.hpp"

#include <algorithm>
#include <set>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/stamps.hpp"

namespace map_matcher::ros_common {
namespace {

constexpr double kIntervals = 3.0;  // that a parent may be silent for

}  // namespace

void FrameParents::add(const tf2_msgs::TFMessage& message, const std::string& publisher, bool is_static,
                       const ros::Time& now) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const std::string parent = frameName(transform.header.frame_id);
    const auto [entry, is_new] =
        by_child_[frameName(transform.child_frame_id)].try_emplace(publisher, Entry{parent, is_static, now, 0.0});
    Entry& known = entry->second;
    if (is_new || (known.is_static && !is_static)) {
      continue;
    }
    const double interval = secondsBetween(known.heard, now);
    const bool goes_on = interval >= 0.0 && interval <= kMostMemory;  // else time jumped, or it was away
    known = {parent, is_static, now, goes_on ? std::max(known.longest_interval, interval) : 0.0};
  }
}

std::optional<FrameParent> FrameParents::parentOf(const std::string& child, const ros::Time& now) const {
  const auto found = by_child_.find(child);
  if (found == by_child_.end()) {
    return std::nullopt;
  }
  const ByPublisher::value_type* best = nullptr;
  const auto rank = [](const Entry& entry) { return std::make_pair(entry.is_static, entry.heard); };
  for (const auto& said : found->second) {
    if (isPresent(said.second, now) && (best == nullptr || rank(said.second) > rank(best->second))) {
      best = &said;
    }
  }
  return best != nullptr ? std::make_optional(FrameParent{best->second.parent, best->first}) : std::nullopt;
}

std::vector<ContestedFrame> FrameParents::contestedAmong(const std::vector<std::string>& frames,
                                                         const ros::Time& now) const {
  std::vector<ContestedFrame> contested;
  for (const std::string& frame : frames) {
    const auto found = by_child_.find(frame);
    if (found == by_child_.end()) {
      continue;
    }
    ContestedFrame candidate{frame, {}};
    std::set<std::string> different;
    for (const auto& [publisher, entry] : found->second) {
      if (isPresent(entry, now)) {
        candidate.parents.push_back({entry.parent, publisher});
        different.insert(entry.parent);
      }
    }
    if (different.size() > 1) {
      contested.push_back(candidate);
    }
  }
  return contested;
}

bool FrameParents::isPresent(const Entry& entry, const ros::Time& now) {
  const double age = secondsBetween(entry.heard, now);  // negative after time went back
  return entry.is_static ||
         (age >= 0.0 && age <= std::clamp(kIntervals * entry.longest_interval, kLeastMemory, kMostMemory));
}

}  // namespace map_matcher::ros_common
