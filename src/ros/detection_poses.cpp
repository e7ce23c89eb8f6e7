#include "map_matcher/ros/detection_poses.hpp"

#include <tf2/exceptions.h>

#include <algorithm>
#include <utility>

#include "map_matcher/ros/detection_messages.hpp"

namespace map_matcher {
namespace {

constexpr double kMaxTransformAge = 0.2;  // [s] a robot hardly moves in that time

ros::Time rosTime(Stamp stamp) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(0, stamp.count())));
}

Eigen::Isometry3d toEigen(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  return Eigen::Translation3d(t.x, t.y, t.z) * Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

}  // namespace

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

DetectionPoses::DetectionPoses(const tf2::BufferCore& tf, std::string fixed_frame)
    : tf_(tf), fixed_frame_(std::move(fixed_frame)) {}

DetectionPose DetectionPoses::lookUp(const FrameAt& set, const FrameAt& scan) const {
  if (const auto pose = throughFixedFrame(set, scan)) {
    return {PosePath::kFixedFrame, pose};
  }
  const std::optional<Stamp> newest = newestStamp(scan.frame);
  if (newest && *newest < scan.stamp && seconds(scan.stamp - *newest) <= kMaxTransformAge) {
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
  if (fixed_frame_.empty()) {
    return std::nullopt;
  }
  try {
    return toEigen(
        tf_.lookupTransform(scan.frame, rosTime(scan.stamp), set.frame, rosTime(set.stamp), fixed_frame_).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::optional<Stamp> DetectionPoses::newestStamp(const std::string& scan_frame) const {
  if (fixed_frame_.empty()) {
    return std::nullopt;
  }
  try {
    return stampOf(tf_.lookupTransform(fixed_frame_, scan_frame, ros::Time(0)).header.stamp);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::optional<Eigen::Isometry3d> DetectionPoses::asIfStandingStill(const std::string& set_frame,
                                                                   const std::string& scan_frame) const {
  if (set_frame == scan_frame) {
    return Eigen::Isometry3d::Identity();
  }
  try {
    return toEigen(tf_.lookupTransform(scan_frame, set_frame, ros::Time(0)).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace map_matcher
