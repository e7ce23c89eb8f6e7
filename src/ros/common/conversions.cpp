#include "map_matcher/ros/common/conversions.hpp"

#include <tf2/LinearMath/Matrix3x3.h>
#include <tf2/LinearMath/Quaternion.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "map_matcher/grid/map_limits.hpp"

namespace map_matcher::ros_common {
namespace {

constexpr double kQuaternionTolerance = 1e-3;  // deviation of the norm from one
constexpr double kTiltTolerance = 1e-3;        // roll and pitch [rad]

template <typename Position>
grid::Rigid2 planar(const Position& position, const geometry_msgs::Quaternion& rotation, const std::string& name) {
  if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
    std::ostringstream text;
    text << name << " has position (" << position.x << ", " << position.y << ", " << position.z
         << "), expected finite numbers";
    throw MessageError(text.str());
  }
  const tf2::Quaternion quaternion(rotation.x, rotation.y, rotation.z, rotation.w);
  double roll = 0.0;
  double pitch = 0.0;
  double yaw = 0.0;
  const double norm = quaternion.length();
  if (std::isfinite(norm) && std::abs(norm - 1.0) <= kQuaternionTolerance) {
    tf2::Matrix3x3(quaternion.normalized()).getRPY(roll, pitch, yaw);
  } else {
    std::ostringstream text;
    text << name << " has quaternion (" << rotation.x << ", " << rotation.y << ", " << rotation.z << ", " << rotation.w
         << ") of norm " << norm << ", expected norm 1";
    throw MessageError(text.str());
  }
  if (std::abs(roll) > kTiltTolerance || std::abs(pitch) > kTiltTolerance) {
    std::ostringstream text;
    text << name << " is tilted by roll " << roll << " and pitch " << pitch << " rad, expected a rotation about z only";
    throw MessageError(text.str());
  }
  return {position.x, position.y, grid::normalizeAngle(yaw)};
}

geometry_msgs::Quaternion quaternionMessage(double yaw) {
  geometry_msgs::Quaternion message;
  message.z = std::sin(0.5 * yaw);
  message.w = std::cos(0.5 * yaw);
  return message;
}

constexpr unsigned char kDelete = 127;

/// The shortest decimal number that a 32-bit float stands for.
double decimalOf(float value) {
  std::ostringstream text;
  text.precision(std::numeric_limits<float>::digits10 + 1);
  text << value;
  return std::strtod(text.str().c_str(), nullptr);
}

}  // namespace

grid::Rigid2 fromMessage(const geometry_msgs::Pose& pose, const std::string& name) {
  return planar(pose.position, pose.orientation, name);
}

grid::Rigid2 fromMessage(const geometry_msgs::Transform& transform, const std::string& name) {
  return planar(transform.translation, transform.rotation, name);
}

geometry_msgs::Pose toPoseMessage(const grid::Rigid2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation = quaternionMessage(pose.yaw);
  return message;
}

geometry_msgs::Transform toTransformMessage(const grid::Rigid2& transform) {
  geometry_msgs::Transform message;
  message.translation.x = transform.x;
  message.translation.y = transform.y;
  message.rotation = quaternionMessage(transform.yaw);
  return message;
}

grid::OccupancyGrid fromMessage(const nav_msgs::OccupancyGrid& message) {
  constexpr auto kMaxSize = static_cast<std::uint32_t>(std::numeric_limits<int>::max());
  if (message.info.width > kMaxSize || message.info.height > kMaxSize) {
    throw MessageError("the map is " + std::to_string(message.info.width) + " x " +
                       std::to_string(message.info.height) + " cells, expected at most 2147483647 a side");
  }
  grid::GridGeometry geometry;
  geometry.resolution = decimalOf(message.info.resolution);
  geometry.width = static_cast<int>(message.info.width);
  geometry.height = static_cast<int>(message.info.height);
  geometry.T_map_grid = fromMessage(message.info.origin, "the map's origin");
  try {
    grid::requireMapLimits(geometry);  // before the values are copied
    return grid::OccupancyGrid(geometry, message.data);
  } catch (const std::invalid_argument& error) {
    throw MessageError(error.what());
  }
}

std::string frameName(const std::string& frame_id) {
  const std::size_t first = frame_id.find_first_not_of('/');
  return first == std::string::npos ? "" : frame_id.substr(first);
}

std::string frameOf(const std_msgs::Header& header) {
  std::string name = frameName(header.frame_id);
  const bool is_name = std::none_of(name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == kDelete; });
  if (name.empty() || !is_name) {
    throw MessageError("header.frame_id is \"" + header.frame_id +
                       "\", expected the name of a frame, without blanks and line breaks");
  }
  return name;
}

nav_msgs::OccupancyGrid toMessage(const grid::OccupancyGrid& grid, const std::string& frame_id,
                                  const ros::Time& stamp) {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = frame_id;
  message.header.stamp = stamp;
  message.info.map_load_time = stamp;
  message.info.resolution = static_cast<float>(grid.resolution());
  message.info.width = static_cast<std::uint32_t>(grid.width());
  message.info.height = static_cast<std::uint32_t>(grid.height());
  message.info.origin = toPoseMessage(grid.geometry().T_map_grid);
  message.data = grid.values();
  return message;
}

}  // namespace map_matcher::ros_common
