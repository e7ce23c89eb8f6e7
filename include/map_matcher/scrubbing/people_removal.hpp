/// \file
/// Takes people out of scans: what the lidar_scrubber, scrub_bag and the trials do, without their topics and clocks.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/scrubbing/detection_cache.hpp"
#include "map_matcher/scrubbing/detection_poses.hpp"
#include "map_matcher/scrubbing/scan_scrubber.hpp"
#include "map_matcher/scrubbing/scrubbed_scan.hpp"
#include "map_matcher/scrubbing/scrubbing_options.hpp"
#include "map_matcher/scrubbing/waiting_scans.hpp"

namespace map_matcher::scrubbing {

/// What became of a set of detections.
struct AddedDetections {
  LeftOut left_out;       ///< By the limits.
  int vetoed = 0;         ///< By the veto.
  std::int64_t used = 0;  ///< All others.
};

/// Remembers detections and takes them out of the scans of one laser, in the order in which these come. Not
/// thread-safe. A clock that never goes back, `now` in what follows, tells how long scans wait.
class PeopleRemoval {
 public:
  /// Number of sets of detections, by how they came into the frame of a scan.
  using PathCounts = std::array<std::int64_t, 4>;

  /// Where the frame of a set, at its stamp, lay as the scan sees it.
  using PoseOf = std::function<DetectionPose(const FrameAt& set, const FrameAt& scan)>;

  /// `wait` [s]: how long a scan waits for the detections made from it (mode synchronised); nothing: it never does
  /// (mode cached).
  PeopleRemoval(const ScrubbingOptions& options, PoseOf pose_of, std::optional<double> wait = std::nullopt);

  /// What counts from the next scan and the next detections on. Nothing is forgotten, and waiting scans go on waiting.
  void setOptions(const ScrubbingOptions& options);

  /// To be called for each scan as it comes. When its stamp went back by more than cache_duration, or its frame is
  /// another than the last one's, forgets all detections and says why. Throws std::invalid_argument for a scan that
  /// makes no sense, which changes nothing.
  std::optional<std::string> onScan(const RawScan& scan);

  /// Hands the scan, of which onScan() thought well, on without the points near people: at once, or when its detections
  /// are there, or when it waited long enough. `hand_on` is called once, from here or from release().
  void scrub(RawScan scan, Stamp now, HandOn hand_on);

  /// Keeps the detections that are within the limits and that are not vetoed for the next scans.
  AddedDetections add(DetectionSet set, const Veto& veto = nullptr);

  /// Hands on the scans that need not wait any longer. To be called after add(), and again and again.
  void release(Stamp now);

  /// How a set would come into the frame of the newest scan; nothing before there is a scan.
  std::optional<PosePath> pathFrom(const FrameAt& set) const;

  Stamp newestScan() const { return newest_scan_; }                   ///< Newest stamp since the last jump.
  const std::string& scanFrame() const { return scan_frame_; }        ///< Of the last scan; empty: none yet.
  const PathCounts& paths() const { return paths_; }                  ///< Since construction.
  const std::vector<Disc>& discs() const { return discs_; }           ///< Circles of the last scan.
  const ScanScrubber& scrubber() const { return scrubber_; }          ///< With the points of the last scan.
  const std::string& unknownFrame() const { return unknown_frame_; }  ///< The last that could not be connected.

 private:
  ScrubbedScan scrubbed(const RawScan& scan);
  RangeRemoval removalFrom(const RawScan& scan);
  std::optional<Eigen::Isometry3d> poseOf(const DetectionSet& set, const FrameAt& scan);

  ScrubbingOptions options_;
  PoseOf pose_of_;
  std::optional<WaitingScans> waiting_;  // nothing: no scan ever waits
  DetectionCache cache_;
  ScanScrubber scrubber_;
  std::vector<Disc> discs_;
  PathCounts paths_{};
  std::string unknown_frame_;
  std::string scan_frame_;
  Stamp newest_scan_{0};
};

}  // namespace map_matcher::scrubbing
