#include "map_matcher/ros/common/detection_messages.hpp"

#include <limits>

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_common {
namespace {

scrubbing::DetectionSet emptySet(const std_msgs::Header& header, const std::string& source) {
  return {source, frameOf(header), stampOf(header.stamp), {}};
}

Eigen::Vector3d toEigen(const geometry_msgs::Point& point) { return {point.x, point.y, point.z}; }

}  // namespace

scrubbing::Stamp stampOf(const ros::Time& time) {
  return std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec);
}

scrubbing::Stamp rosNow() { return stampOf(ros::Time::now()); }

std::optional<ros::Time> rosTimeOf(scrubbing::Stamp stamp) {
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(stamp);
  if (stamp < scrubbing::Stamp(0) || whole.count() > std::numeric_limits<std::uint32_t>::max()) {
    return std::nullopt;
  }
  return ros::Time(static_cast<std::uint32_t>(whole.count()), static_cast<std::uint32_t>((stamp - whole).count()));
}

scrubbing::DetectionSet fromMessage(const geometry_msgs::PoseArray& message, const std::string& source) {
  scrubbing::DetectionSet set = emptySet(message.header, source);
  set.detections.reserve(message.poses.size());
  for (const geometry_msgs::Pose& pose : message.poses) {
    set.detections.push_back({toEigen(pose.position), 1.0});
  }
  return set;
}

scrubbing::DetectionSet fromMessage(const PersonDetections& message, const std::string& source) {
  scrubbing::DetectionSet set = emptySet(message.header, source);
  set.detections.reserve(message.detections.size());
  for (const PersonDetection& detection : message.detections) {
    set.detections.push_back({toEigen(detection.position), static_cast<double>(detection.score)});
  }
  return set;
}

}  // namespace map_matcher::ros_common
