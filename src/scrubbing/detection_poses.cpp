#include "map_matcher/scrubbing/detection_poses.hpp"

#include <algorithm>
#include <utility>

namespace map_matcher::scrubbing {

const char* toString(PosePath path) {
  switch (path) {
    case PosePath::kFixedFrame:
      return "through the fixed frame";
    case PosePath::kNewest:
      return "through the fixed frame at the newest transform";
    case PosePath::kSensorFrame:
      return "in the sensor frame, as if the robot stood still";
    case PosePath::kNone:
      break;
  }
  return "not at all";
}

std::optional<Eigen::Isometry3d> poseAt(const FrameTransforms& transforms, const std::string& target,
                                        const FrameAt& source, Stamp max_age) {
  if (auto pose = transforms.through(target, {target, source.stamp}, source)) {
    return pose;
  }
  const std::optional<Stamp> newest = transforms.newest(target, source.frame);
  if (!newest || *newest > source.stamp || source.stamp - *newest > max_age) {
    return std::nullopt;
  }
  return transforms.through(target, {target, *newest}, {source.frame, *newest});
}

DetectionPoses::DetectionPoses(const FrameTransforms& transforms, std::string fixed_frame)
    : transforms_(transforms), fixed_frame_(std::move(fixed_frame)) {}

DetectionPose DetectionPoses::lookUp(const FrameAt& set, const FrameAt& scan) const {
  if (const auto pose = throughFixedFrame(set, scan)) {
    return {PosePath::kFixedFrame, pose};
  }
  const std::optional<Stamp> newest =
      fixed_frame_.empty() ? std::nullopt : transforms_.newest(fixed_frame_, scan.frame);
  if (newest && *newest < scan.stamp && scan.stamp - *newest <= kMaxTransformAge) {
    if (const auto pose = throughFixedFrame({set.frame, std::min(set.stamp, *newest)}, {scan.frame, *newest})) {
      return {PosePath::kNewest, pose};
    }
  }
  if (const auto pose = asIfStandingStill(set.frame, scan.frame)) {
    return {PosePath::kSensorFrame, pose};
  }
  return {};
}

std::optional<Eigen::Isometry3d> DetectionPoses::throughFixedFrame(const FrameAt& set, const FrameAt& scan) const {
  return fixed_frame_.empty() ? std::nullopt : transforms_.through(fixed_frame_, scan, set);
}

std::optional<Eigen::Isometry3d> DetectionPoses::asIfStandingStill(const std::string& set_frame,
                                                                   const std::string& scan_frame) const {
  return set_frame == scan_frame ? Eigen::Isometry3d::Identity() : transforms_.latest(scan_frame, set_frame);
}

}  // namespace map_matcher::scrubbing
