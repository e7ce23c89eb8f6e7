#include "map_matcher/ros/common/scan_conversions.hpp"

#include <tf2/LinearMath/Matrix3x3.h>
#include <tf2/LinearMath/Quaternion.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <stdexcept>

#include "map_matcher/parameters/number_text.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/detection_messages.hpp"

namespace map_matcher::ros_common {
namespace {

constexpr double kQuaternionTolerance = 1e-3;  // deviation of the norm from one
constexpr double kAngleTolerance = 0.01;       // [rad] of angle_max, besides two beams
constexpr double kTiltTolerance = 1e-3;        // deviation of the laser's z axis from vertical, as 1 - |cosine|
constexpr double kFarthest = 1e8;              // [m] no robot is farther from anything; its cells are numbers still

tf2::Matrix3x3 rotationOf(const geometry_msgs::Transform& transform, const std::string& name) {
  const auto& t = transform.translation;
  if (!(std::abs(t.x) <= kFarthest && std::abs(t.y) <= kFarthest && std::abs(t.z) <= kFarthest)) {
    throw MessageError(name + " has translation (" + parameters::numberText(t.x) + ", " + parameters::numberText(t.y) +
                       ", " + parameters::numberText(t.z) + "), expected numbers within " +
                       parameters::numberText(kFarthest) + " m");
  }
  const auto& q = transform.rotation;
  const tf2::Quaternion quaternion(q.x, q.y, q.z, q.w);
  const double norm = quaternion.length();
  if (!(std::abs(norm - 1.0) <= kQuaternionTolerance)) {
    throw MessageError(name + " has a quaternion of norm " + std::to_string(norm) + ", expected norm 1");
  }
  return tf2::Matrix3x3(quaternion.normalized());
}

double yawOf(const tf2::Matrix3x3& rotation) { return std::atan2(rotation[1][0], rotation[0][0]); }

}  // namespace

scan::ScanLayout layoutOf(const sensor_msgs::LaserScan& message) {
  return {static_cast<double>(message.angle_min), static_cast<double>(message.angle_increment),
          static_cast<double>(message.range_min), static_cast<double>(message.range_max)};
}

void checkLayout(const sensor_msgs::LaserScan& message) {
  const scan::ScanLayout layout = layoutOf(message);
  try {
    layout.validate();
  } catch (const std::invalid_argument& error) {
    throw MessageError(error.what());
  }
  if (message.ranges.empty()) {
    throw MessageError("the scan has 0 ranges, expected at least 1");
  }
  const double last_angle = layout.angle_min + layout.angle_increment * static_cast<double>(message.ranges.size() - 1);
  const auto angle_max = static_cast<double>(message.angle_max);
  if (!(std::abs(angle_max - last_angle) <= kAngleTolerance + 2.0 * std::abs(layout.angle_increment))) {
    throw MessageError("angle_max is " + std::to_string(angle_max) + ", expected the angle of the last of the " +
                       std::to_string(message.ranges.size()) + " beams, " + std::to_string(last_angle) + " rad");
  }
}

scrubbing::RawScan rawScanOf(const sensor_msgs::LaserScanConstPtr& message) {
  checkLayout(*message);
  const std::shared_ptr<const std::vector<float>> ranges(&message->ranges, [message](const auto* /*its part*/) {});
  return {frameOf(message->header), stampOf(message->header.stamp), layoutOf(*message), ranges};
}

sensor_msgs::LaserScanConstPtr scrubbedMessage(const sensor_msgs::LaserScanConstPtr& message,
                                               const scrubbing::RangeRemoval& removal) {
  if (removal.removed.empty()) {
    return message;
  }
  const auto scrubbed = boost::make_shared<sensor_msgs::LaserScan>(*message);
  scrubbed->ranges = removal.ranges;
  return scrubbed;
}

scan::PlanarScan fromMessage(const sensor_msgs::LaserScan& message) {
  scan::PlanarScan scan{layoutOf(message), message.ranges};
  try {
    scan.validate();
  } catch (const std::invalid_argument& error) {
    throw MessageError(error.what());
  }
  return scan;
}

scan::LaserMount laserMountFrom(const geometry_msgs::Transform& T_base_laser) {
  const tf2::Matrix3x3 rotation = rotationOf(T_base_laser, "the mount of the laser");
  const double up = rotation[2][2];  // vertical part of the laser's z axis
  if (std::abs(std::abs(up) - 1.0) > kTiltTolerance) {
    throw MessageError("the laser's z axis has a vertical part of " + std::to_string(up) +
                       ", expected 1 (upright) or -1 (upside down): it has to scan parallel to the floor");
  }
  return {{T_base_laser.translation.x, T_base_laser.translation.y, yawOf(rotation)}, up < 0.0};
}

grid::Rigid2 projectToPlane(const geometry_msgs::Transform& transform, const std::string& name) {
  const tf2::Matrix3x3 rotation = rotationOf(transform, name);
  return {transform.translation.x, transform.translation.y, yawOf(rotation)};
}

}  // namespace map_matcher::ros_common
