#include "map_matcher/scrubbing/detection_cache.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace map_matcher::scrubbing {
namespace {

constexpr std::size_t kMaxSets = 256;  // a second of eight detectors at 30 Hz

}  // namespace

void DetectionCache::add(DetectionSet set) {
  if (set.detections.empty()) {
    return;
  }
  if (sets_.size() == kMaxSets) {
    sets_.pop_front();
  }
  sets_.push_back(std::move(set));
}

void DetectionCache::forget(Stamp scan_stamp) {
  const auto outlived = [&](const DetectionSet& set) { return set.stamp < scan_stamp && !applies(set, scan_stamp); };
  sets_.erase(std::remove_if(sets_.begin(), sets_.end(), outlived), sets_.end());
}

const std::vector<Disc>& DetectionCache::discsAt(Stamp scan_stamp, const PoseOfSet& pose_of_set) {
  discs_.clear();
  for (const DetectionSet& set : sets_) {
    const std::optional<Eigen::Isometry3d> T_scan_set =
        applies(set, scan_stamp) ? pose_of_set(set) : std::optional<Eigen::Isometry3d>();
    if (!T_scan_set) {
      continue;
    }
    const double age = std::abs(seconds(scan_stamp - set.stamp));
    const double most = std::max(options_.removal_radius, options_.max_removal_radius);
    const double radius = std::min(options_.removal_radius + options_.radius_growth * age, most);
    for (const Detection& detection : set.detections) {
      discs_.push_back({(*T_scan_set * detection.position).head<2>(), radius});
    }
  }
  return discs_;
}

bool DetectionCache::applies(const DetectionSet& set, Stamp scan_stamp) const {
  return std::abs(seconds(scan_stamp - set.stamp)) <= options_.cache_duration;
}

}  // namespace map_matcher::scrubbing
