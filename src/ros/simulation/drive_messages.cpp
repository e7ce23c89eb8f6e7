#include "map_matcher/ros/simulation/drive_messages.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_simulation {
namespace {

const ros::Duration kShortestLatency(0.003);  // of detections, which come after their scan

std_msgs::Header headerOf(const std::string& frame, const ros::Time& stamp, std::uint32_t number) {
  std_msgs::Header header;
  header.seq = number;
  header.stamp = stamp;
  header.frame_id = frame;
  return header;
}

geometry_msgs::TransformStamped toMessage(const std_msgs::Header& header, const std::string& child,
                                          const grid::Rigid2& T_parent_child) {
  geometry_msgs::TransformStamped message;
  message.header = header;
  message.child_frame_id = child;
  message.transform = ros_common::toTransformMessage(T_parent_child);
  return message;
}

geometry_msgs::Point toMessage(const Eigen::Vector2d& position) {
  geometry_msgs::Point message;
  message.x = position.x();
  message.y = position.y();
  return message;
}

void checkOptions(const DriveMessageOptions& options, std::size_t num_lidars) {
  constexpr double kFirst = 1.0;  // a stamp of 0 stands for none
  constexpr double kLast = 4e9;   // ros::Time counts seconds in 32 bits
  if (!(options.start_stamp >= kFirst && options.start_stamp <= kLast)) {
    throw std::invalid_argument("start_stamp is " + std::to_string(options.start_stamp) + ", expected 1 to 4e9 s");
  }
  if (options.lidars.size() != num_lidars) {
    throw std::invalid_argument("there are names for " + std::to_string(options.lidars.size()) + " lidars, expected " +
                                std::to_string(num_lidars));
  }
}

}  // namespace

std::vector<LidarNames> lidarNames(std::size_t count) {
  const std::string poses = "dr_spaam_detections/";
  const std::string scored = "person_detections/";
  if (count == 1) {
    return {LidarNames{}};
  }
  if (count == 2) {
    return {{"sick_laser_front/scan", poses + "front", scored + "front", "sick_laser_front"},
            {"sick_laser_rear/scan", poses + "rear", scored + "rear", "sick_laser_rear"}};
  }
  std::vector<LidarNames> names;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string name = "laser_" + std::to_string(i);
    names.push_back({name + "/scan", poses + name, scored + name, name});
  }
  return names;
}

DriveMessages::DriveMessages(DriveDescription drive, const DriveMessageOptions& options)
    : drive_(std::move(drive)), options_(options) {
  if (options_.lidars.empty()) {
    options_.lidars = lidarNames(drive_.T_base_lidar.size());
  }
  checkOptions(options_, drive_.T_base_lidar.size());
}

ros::Time DriveMessages::stampAt(double time) const {
  ros::Duration since_start;
  since_start.fromNSec(std::llround(time * 1e9));
  return ros::Time(options_.start_stamp) + since_start;
}

tf2_msgs::TFMessage DriveMessages::transforms(const Source& source) const {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(toMessage(headerOf(options_.odometry_frame, source.stamp, source.number),
                                         options_.base_frame, source.step.T_odom_base));
  for (std::size_t i = 0; i < drive_.T_base_lidar.size(); ++i) {
    message.transforms.push_back(toMessage(headerOf(options_.base_frame, source.stamp, source.number),
                                           options_.lidars[i].frame, drive_.T_base_lidar[i]));
  }
  return message;
}

nav_msgs::Odometry DriveMessages::odometry(const Source& source) const {
  nav_msgs::Odometry message;
  message.header = headerOf(options_.odometry_frame, source.stamp, source.number);
  message.child_frame_id = options_.base_frame;
  message.pose.pose = ros_common::toPoseMessage(source.step.T_odom_base);
  message.twist.twist.linear.x = source.step.velocity.linear;
  message.twist.twist.angular.z = source.step.velocity.angular;
  return message;
}

geometry_msgs::PoseStamped DriveMessages::truth(const Source& source) const {
  geometry_msgs::PoseStamped message;
  message.header = headerOf(options_.map_frame, source.stamp, source.number);
  message.pose = ros_common::toPoseMessage(source.step.T_map_base);
  return message;
}

geometry_msgs::PoseArray DriveMessages::people(const Source& source) const {
  geometry_msgs::PoseArray message;
  message.header = headerOf(options_.map_frame, source.stamp, source.number);
  message.poses.reserve(source.step.people.size());
  for (const simulation::Person& person : source.step.people) {
    message.poses.push_back(ros_common::toPoseMessage({person.position.x(), person.position.y(), person.heading}));
  }
  return message;
}

sensor_msgs::LaserScan DriveMessages::scan(const Source& source, std::size_t lidar) const {
  const scan::PlanarScan& scan = source.step.scans[lidar];
  sensor_msgs::LaserScan message;
  message.header = headerOf(options_.lidars[lidar].frame, source.stamp, source.number);
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  const auto last_ray = static_cast<double>(scan.ranges.size()) - 1.0;
  message.angle_max = static_cast<float>(scan.angle_min + last_ray * scan.angle_increment);
  message.scan_time = static_cast<float>(drive_.period);
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges = scan.ranges;
  return message;
}

geometry_msgs::PoseArray DriveMessages::detections(const Source& source, std::size_t lidar) const {
  geometry_msgs::PoseArray message;
  message.header = headerOf(options_.lidars[lidar].frame, source.stamp, source.number);
  for (const simulation::DetectedPerson& detection : source.step.detections[lidar]->people) {
    if (detection.score >= options_.score_threshold) {
      message.poses.emplace_back();
      message.poses.back().position = toMessage(detection.position);
    }
  }
  return message;
}

PersonDetections DriveMessages::scoredDetections(const Source& source, std::size_t lidar) const {
  PersonDetections message;
  message.header = headerOf(options_.lidars[lidar].frame, source.stamp, source.number);
  for (const simulation::DetectedPerson& detection : source.step.detections[lidar]->people) {
    message.detections.emplace_back();
    message.detections.back().position = toMessage(detection.position);
    message.detections.back().score = static_cast<float>(detection.score);
  }
  return message;
}

ros::Time DriveMessages::arrivalOfDetections(const Source& source, std::size_t lidar) const {
  return std::max(source.stamp + kShortestLatency, stampAt(source.step.detections[lidar]->arrival));
}

}  // namespace map_matcher::ros_simulation
