/// \file
/// Remembers detections for the next scans, since detectors miss people now and then (report section 2.2).
#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "map_matcher/scrubbing/detections.hpp"
#include "map_matcher/scrubbing/scan_scrubber.hpp"

namespace map_matcher::scrubbing {

/// Where and how long detections apply. Ranges stand in parametersOf(ScrubbingOptions&).
struct CacheOptions {
  double cache_duration = 0.25;     ///< [s] A detection applies to scans whose stamps differ from its own by no more.
  double removal_radius = 0.3;      ///< [m] Of the circle around a detection (report section 2.2).
  double radius_growth = 0.0;       ///< [m/s] By which the radius grows with the age of the detection.
  double max_removal_radius = 0.6;  ///< [m] To which it grows.
};

/// Detections of the last moments. Not thread-safe.
class DetectionCache {
 public:
  /// T_scan_set: where the frame of a set, at the set's stamp, lay as the scan sees it; nothing when nobody knows.
  using PoseOfSet = std::function<std::optional<Eigen::Isometry3d>(const DetectionSet&)>;

  explicit DetectionCache(const CacheOptions& options) : options_(options) {}

  /// Keeps a set until scans are so much newer that it does not apply any more. When there are very many sets, the one
  /// that came first is dropped.
  void add(DetectionSet set);

  void clear() { sets_.clear(); }

  /// What counts from the next scan on, for the sets that are kept, too.
  void setOptions(const CacheOptions& options) { options_ = options; }

  /// Drops the sets that apply neither to a scan of this stamp nor to later ones.
  void forget(Stamp scan_stamp);

  std::size_t size() const { return sets_.size(); }  ///< Number of sets kept.

  /// The circles, in the scan's frame, that the kept detections draw around people for a scan of this stamp. Sets whose
  /// pose is not known are left out. The reference holds until the next call.
  const std::vector<Disc>& discsAt(Stamp scan_stamp, const PoseOfSet& pose_of_set);

 private:
  bool applies(const DetectionSet& set, Stamp scan_stamp) const;

  CacheOptions options_;
  std::deque<DetectionSet> sets_;
  std::vector<Disc> discs_;  // a member, so that its memory is used again
};

}  // namespace map_matcher::scrubbing
