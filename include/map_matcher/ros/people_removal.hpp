/// \file
/// Takes people out of scan messages: what the lidar_scrubber does, without its topics.
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/ros/detection_poses.hpp"
#include "map_matcher/scrubbing/detection_cache.hpp"
#include "map_matcher/scrubbing/scan_scrubber.hpp"
#include "map_matcher/scrubbing/scrubbing_options.hpp"

namespace map_matcher {

/// What became of a scan.
struct ScrubbedScan {
  sensor_msgs::LaserScanConstPtr scan;  ///< The one given when nothing was removed.
  std::vector<std::uint32_t> removed;   ///< Beams that were removed, in rising order.
  std::size_t near_people = 0;          ///< Points near people; more than `removed` when that was too many.
  int points = 0;                       ///< Points that the scan measured.

  bool tooMany() const { return near_people > removed.size(); }  ///< Whether max_removed_fraction was exceeded.
};

/// Remembers detections and takes them out of scans. Not thread-safe.
class PeopleRemoval {
 public:
  /// Number of sets of detections, by how they came into the frame of a scan.
  using PathCounts = std::array<std::int64_t, 4>;

  /// `tf` must outlive this. `fixed_frame` as in DetectionPoses.
  PeopleRemoval(const tf2::BufferCore& tf, const std::string& fixed_frame, const ScrubbingOptions& options);

  /// To be called for each scan as it comes. When its stamp went back by more than cache_duration, or its frame is
  /// another than the last one's, forgets all detections and says why. Throws MessageError for a scan that makes no
  /// sense, which changes nothing.
  std::optional<std::string> onScan(const sensor_msgs::LaserScan& scan);

  /// Detections within the limits, for the next scans.
  void add(DetectionSet set) { cache_.add(std::move(set)); }

  /// The scan, of which onScan() thought well, without the points near people.
  ScrubbedScan scrub(const sensor_msgs::LaserScanConstPtr& scan);

  Stamp newestScan() const { return newest_scan_; }                   ///< Newest stamp since the last jump.
  const PathCounts& paths() const { return paths_; }                  ///< Since construction.
  const std::vector<Disc>& discs() const { return discs_; }           ///< Circles of the last scan.
  const ScanScrubber& scrubber() const { return scrubber_; }          ///< With the points of the last scan.
  const std::string& unknownFrame() const { return unknown_frame_; }  ///< The last that tf could not connect.

 private:
  std::optional<Eigen::Isometry3d> poseOf(const DetectionSet& set, const FrameAt& scan);

  ScrubbingOptions options_;
  DetectionPoses poses_;
  DetectionCache cache_;
  ScanScrubber scrubber_;
  std::vector<Disc> discs_;
  PathCounts paths_{};
  std::string unknown_frame_;
  std::string scan_frame_;  // of the last scan; empty: none yet
  Stamp newest_scan_{0};
};

}  // namespace map_matcher
