#include "map_matcher/ros/common/tf_transforms.hpp"

#include <tf2/exceptions.h>

#include "map_matcher/ros/common/detection_messages.hpp"

namespace map_matcher::ros_common {
namespace {

Eigen::Isometry3d toEigen(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  return Eigen::Translation3d(t.x, t.y, t.z) * Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

}  // namespace

std::optional<Eigen::Isometry3d> TfTransforms::through(const std::string& fixed_frame, const scrubbing::FrameAt& target,
                                                       const scrubbing::FrameAt& source) const {
  const std::optional<ros::Time> target_time = rosTimeOf(target.stamp);
  const std::optional<ros::Time> source_time = rosTimeOf(source.stamp);
  if (!target_time || !source_time) {
    return std::nullopt;
  }
  try {
    return toEigen(tf_.lookupTransform(target.frame, *target_time, source.frame, *source_time, fixed_frame).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::optional<scrubbing::Stamp> TfTransforms::newest(const std::string& target, const std::string& source) const {
  try {
    return stampOf(tf_.lookupTransform(target, source, ros::Time(0)).header.stamp);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::optional<Eigen::Isometry3d> TfTransforms::latest(const std::string& target, const std::string& source) const {
  try {
    return toEigen(tf_.lookupTransform(target, source, ros::Time(0)).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace map_matcher::ros_common
