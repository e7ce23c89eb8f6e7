/// \file
/// Messages as anybody may publish them. Their fields are taken from a fuzzer's input rather than the messages from
/// their serialised form, which ROS reads: what is tried here is what becomes of their values. Stamps, frames and maps
/// may be chosen so that they fit together, or be anything.
#pragma once

#include <geometry_msgs/Transform.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Header.h>
#include <tf2/buffer_core.h>

#include <array>
#include <cmath>
#include <string>

#include "bytes.hpp"

namespace map_matcher::fuzz {

inline ros::Time takeStamp(Bytes& bytes) {
  ros::Time stamp;
  if (bytes.choose(3) != 0) {
    stamp.sec = 100;
    stamp.nsec = 10'000U * bytes.take<std::uint16_t>();
  } else {
    stamp.sec = bytes.take<std::uint32_t>();
    stamp.nsec = bytes.take<std::uint32_t>();
  }
  return stamp;
}

inline std::string takeFrame(Bytes& bytes) {
  const std::array<std::string, 5> frames{"laser", "/laser", "base_link", "odom", "map"};
  const auto choice = static_cast<std::size_t>(bytes.choose(static_cast<int>(frames.size())));
  return choice < frames.size() ? frames[choice] : bytes.text();
}

inline std_msgs::Header takeHeader(Bytes& bytes) {
  std_msgs::Header header;
  header.stamp = takeStamp(bytes);
  header.frame_id = takeFrame(bytes);
  return header;
}

/// Of a turn about z, or anything.
inline geometry_msgs::Quaternion takeRotation(Bytes& bytes) {
  geometry_msgs::Quaternion rotation;
  if (bytes.choose(3) != 0) {
    const double half_yaw = 0.0125 * bytes.take<std::uint8_t>();
    rotation.z = std::sin(half_yaw);
    rotation.w = std::cos(half_yaw);
  } else {
    rotation.x = bytes.take<double>();
    rotation.y = bytes.take<double>();
    rotation.z = bytes.take<double>();
    rotation.w = bytes.take<double>();
  }
  return rotation;
}

/// A coordinate within 13 m, or anything.
inline double takeCoordinate(Bytes& bytes) {
  return bytes.choose(3) != 0 ? 0.1 * bytes.take<std::int8_t>() : bytes.take<double>();
}

template <typename Vector>
Vector takeVector(Bytes& bytes) {
  Vector vector;
  vector.x = takeCoordinate(bytes);
  vector.y = takeCoordinate(bytes);
  vector.z = takeCoordinate(bytes);
  return vector;
}

inline geometry_msgs::Pose takePose(Bytes& bytes) {
  geometry_msgs::Pose pose;
  pose.position = takeVector<geometry_msgs::Point>(bytes);
  pose.orientation = takeRotation(bytes);
  return pose;
}

inline geometry_msgs::Transform takeTransform(Bytes& bytes) {
  geometry_msgs::Transform transform;
  transform.translation = takeVector<geometry_msgs::Vector3>(bytes);
  transform.rotation = takeRotation(bytes);
  return transform;
}

/// A small map of walls, free and unknown cells, or anything with up to 4096 values.
inline nav_msgs::OccupancyGrid takeMap(Bytes& bytes) {
  nav_msgs::OccupancyGrid map;
  map.header = takeHeader(bytes);
  map.info.origin = takePose(bytes);
  const bool fits = bytes.choose(7) != 0;
  map.info.resolution = fits ? 0.01F * static_cast<float>(1 + bytes.choose(255)) : bytes.take<float>();
  map.info.width = fits ? 1U + static_cast<std::uint32_t>(bytes.choose(63)) : bytes.take<std::uint32_t>();
  map.info.height = fits ? 1U + static_cast<std::uint32_t>(bytes.choose(63)) : bytes.take<std::uint32_t>();
  map.data.resize(fits ? map.info.width * map.info.height : bytes.take<std::uint16_t>() % 4096U);
  std::uint32_t cells = 0;  // two bits each
  for (std::size_t k = 0; k < map.data.size(); ++k) {
    cells = k % 4 == 0 ? bytes.take<std::uint8_t>() : cells >> 2U;
    const std::array<std::int8_t, 4> values{0, 100, -1, fits ? std::int8_t{50} : static_cast<std::int8_t>(k)};
    map.data[k] = values[cells & 3U];
  }
  return map;
}

/// A scan of up to 255 beams, whose angles may agree.
inline sensor_msgs::LaserScan takeScan(Bytes& bytes) {
  sensor_msgs::LaserScan scan;
  scan.header = takeHeader(bytes);
  scan.ranges.resize(bytes.take<std::uint8_t>());
  const bool fits = bytes.choose(7) != 0;
  scan.angle_min = fits ? -0.05F * static_cast<float>(bytes.choose(255)) : bytes.take<float>();
  scan.angle_increment = fits ? 0.001F * static_cast<float>(bytes.take<std::int8_t>()) : bytes.take<float>();
  scan.angle_max = bytes.choose(7) != 0
                       ? scan.angle_min + scan.angle_increment * (static_cast<float>(scan.ranges.size()) - 1.0F)
                       : bytes.take<float>();
  scan.range_min = fits ? 0.05F : bytes.take<float>();
  scan.range_max = fits ? 0.5F * static_cast<float>(bytes.choose(100)) : bytes.take<float>();
  scan.time_increment = fits ? 1e-5F : bytes.take<float>();
  for (float& range : scan.ranges) {
    range = bytes.choose(15) != 0 ? 0.05F * static_cast<float>(bytes.take<std::uint8_t>()) : bytes.take<float>();
  }
  return scan;
}

/// A transform that tf takes: what it does not take it tells, again and again.
inline geometry_msgs::Transform takeTransformForTf(Bytes& bytes) {
  geometry_msgs::Transform transform = takeTransform(bytes);
  auto& t = transform.translation;
  if (!std::isfinite(t.x) || !std::isfinite(t.y) || !std::isfinite(t.z)) {
    t = geometry_msgs::Vector3();
  }
  geometry_msgs::Quaternion& q = transform.rotation;
  if (!(std::abs(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1.0) < 1e-6)) {
    q = geometry_msgs::Quaternion();
    q.w = 1.0;
  }
  return transform;
}

/// tf with the robot in odom and its laser on it, both at rest.
inline void takeTf(Bytes& bytes, tf2::BufferCore& tf) {
  geometry_msgs::TransformStamped robot;
  robot.header.frame_id = "odom";
  robot.child_frame_id = "base_link";
  robot.transform = takeTransformForTf(bytes);
  geometry_msgs::TransformStamped laser;
  laser.header.frame_id = "base_link";
  laser.child_frame_id = "laser";
  laser.transform = takeTransformForTf(bytes);
  tf.setTransform(robot, "fuzz", true);
  tf.setTransform(laser, "fuzz", true);
}

}  // namespace map_matcher::fuzz
