#include "map_matcher/scrubbing/people_removal.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

namespace map_matcher::scrubbing {

PeopleRemoval::PeopleRemoval(const ScrubbingOptions& options, PoseOf pose_of, std::optional<double> wait)
    : options_(options), pose_of_(std::move(pose_of)), cache_(options.cache) {
  if (wait) {
    waiting_.emplace(fromSeconds(*wait));
  }
}

void PeopleRemoval::setOptions(const ScrubbingOptions& options) {
  options_ = options;
  cache_.setOptions(options.cache);
}

std::optional<std::string> PeopleRemoval::onScan(const RawScan& scan) {
  scan.layout.validate();
  if (scan.ranges->empty()) {
    throw std::invalid_argument("the scan has 0 ranges, expected at least 1");
  }
  std::optional<std::string> reason;
  if (!scan_frame_.empty() && scan.frame != scan_frame_) {
    reason = "the frame of the scans is now " + scan.frame + " instead of " + scan_frame_;
  } else if (seconds(newest_scan_ - scan.stamp) > options_.cache.cache_duration) {
    reason = "the stamps of the scans went back by " + std::to_string(seconds(newest_scan_ - scan.stamp)) + " s";
  }
  if (reason) {
    cache_.clear();
  }
  scan_frame_ = scan.frame;
  newest_scan_ = reason ? scan.stamp : std::max(scan.stamp, newest_scan_);
  return reason;
}

void PeopleRemoval::scrub(RawScan scan, Stamp now, HandOn hand_on) {
  if (waiting_) {
    waiting_->add(std::move(scan), now, std::move(hand_on));
    release(now);
  } else {
    hand_on(scrubbed(scan));
  }
}

AddedDetections PeopleRemoval::add(DetectionSet set, const Veto& veto) {
  AddedDetections added;
  added.left_out = applyLimits(set, options_.limits);
  added.vetoed = applyVeto(set, veto);
  added.used = static_cast<std::int64_t>(set.detections.size());
  if (waiting_) {
    waiting_->onDetections(set.frame, set.stamp);
  }
  cache_.add(std::move(set));
  return added;
}

void PeopleRemoval::release(Stamp now) {
  while (auto released = waiting_ ? waiting_->release(now) : std::nullopt) {
    ScrubbedScan scan = scrubbed(released->scan);
    scan.answered = released->answered;
    released->hand_on(scan);
  }
}

std::optional<PosePath> PeopleRemoval::pathFrom(const FrameAt& set) const {
  return scan_frame_.empty() ? std::nullopt : std::optional<PosePath>(pose_of_(set, {scan_frame_, newest_scan_}).path);
}

/// Whatever goes wrong with a scan, it is handed on: who takes it decides whether people in it are worse than no scan.
ScrubbedScan PeopleRemoval::scrubbed(const RawScan& scan) {
  try {
    return {removalFrom(scan), true, ""};
  } catch (const std::exception& error) {
    return {{*scan.ranges, {}, 0, 0}, true, error.what()};
  }
}

RangeRemoval PeopleRemoval::removalFrom(const RawScan& scan) {
  const FrameAt at{scan.frame, scan.stamp};
  discs_ = cache_.discsAt(scan.stamp, [&](const DetectionSet& set) { return poseOf(set, at); });
  cache_.forget(scan.stamp);
  return removeRanges(scan.layout, *scan.ranges, discs_, options_, scrubber_);
}

std::optional<Eigen::Isometry3d> PeopleRemoval::poseOf(const DetectionSet& set, const FrameAt& scan) {
  const DetectionPose pose = pose_of_({set.frame, set.stamp}, scan);
  ++paths_[static_cast<std::size_t>(pose.path)];
  if (pose.path == PosePath::kNone) {
    unknown_frame_ = set.frame;
  }
  return pose.T_scan_set;
}

}  // namespace map_matcher::scrubbing
