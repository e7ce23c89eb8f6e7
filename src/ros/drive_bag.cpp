#include "map_matcher/ros/drive_bag.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdint>

#include "map_matcher/ros/conversions.hpp"

namespace map_matcher {
namespace {

/// [s] A bag does not keep the order of messages that arrived at the same time: the scan must come later than its
/// transform. Twice this is less than the shortest time between two scans.
const ros::Duration kArrival(0.001);

/// The messages of one drive.
class DriveMessages {
 public:
  DriveMessages(const Drive& drive, const DriveBagOptions& options)
      : drive_(drive), options_(options), start_(options.start_stamp) {}

  ros::Time stampOf(const DriveStep& step) const {
    ros::Duration since_start;
    since_start.fromNSec(std::llround(step.time * 1e9));
    return start_ + since_start;
  }

  sensor_msgs::LaserScan scan(const DriveStep& step) const {
    sensor_msgs::LaserScan message;
    message.header = header(step, options_.lidar_frame);
    message.angle_min = static_cast<float>(step.scan.angle_min);
    message.angle_increment = static_cast<float>(step.scan.angle_increment);
    const auto last_ray = static_cast<double>(step.scan.ranges.size()) - 1.0;
    message.angle_max = static_cast<float>(step.scan.angle_min + last_ray * step.scan.angle_increment);
    message.scan_time = drive_.steps.size() > 1 ? static_cast<float>(drive_.steps[1].time) : 0.0F;
    message.range_min = static_cast<float>(step.scan.range_min);
    message.range_max = static_cast<float>(step.scan.range_max);
    message.ranges = step.scan.ranges;
    return message;
  }

  nav_msgs::Odometry odometry(const DriveStep& step) const {
    nav_msgs::Odometry message;
    message.header = header(step, options_.odometry_frame);
    message.child_frame_id = options_.base_frame;
    message.pose.pose = toPoseMessage(step.T_odom_base);
    message.twist.twist.linear.x = step.velocity.linear;
    message.twist.twist.angular.z = step.velocity.angular;
    return message;
  }

  geometry_msgs::PoseStamped truth(const DriveStep& step) const {
    geometry_msgs::PoseStamped message;
    message.header = header(step, options_.map_frame);
    message.pose = toPoseMessage(step.T_map_base);
    return message;
  }

  tf2_msgs::TFMessage transforms(const DriveStep& step) const {
    tf2_msgs::TFMessage message;
    message.transforms.resize(2);
    message.transforms[0].header = header(step, options_.odometry_frame);
    message.transforms[0].child_frame_id = options_.base_frame;
    message.transforms[0].transform = toTransformMessage(step.T_odom_base);
    message.transforms[1].header = header(step, options_.base_frame);
    message.transforms[1].child_frame_id = options_.lidar_frame;
    message.transforms[1].transform = toTransformMessage(drive_.T_base_lidar);
    return message;
  }

 private:
  std_msgs::Header header(const DriveStep& step, const std::string& frame) const {
    std_msgs::Header header;
    header.seq = static_cast<std::uint32_t>(&step - drive_.steps.data());
    header.stamp = stampOf(step);
    header.frame_id = frame;
    return header;
  }

  const Drive& drive_;
  const DriveBagOptions& options_;
  ros::Time start_;
};

void checkStamp(const DriveBagOptions& options) {
  constexpr double kFirst = 1.0;  // rosbag refuses a stamp of 0
  constexpr double kLast = 4e9;   // ros::Time counts seconds in 32 bits
  if (!(options.start_stamp >= kFirst && options.start_stamp <= kLast)) {
    throw DriveBagError("start_stamp is " + std::to_string(options.start_stamp) + ", expected 1 to 4e9 s");
  }
}

}  // namespace

void writeDriveBag(const Drive& drive, const std::string& path, const DriveBagOptions& options) {
  checkStamp(options);
  const DriveMessages messages(drive, options);
  try {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    for (const DriveStep& step : drive.steps) {
      const ros::Time stamp = messages.stampOf(step);
      bag.write("/tf", stamp, messages.transforms(step));
      bag.write(options.odometry_topic, stamp + kArrival, messages.odometry(step));
      bag.write(options.truth_topic, stamp + kArrival, messages.truth(step));
      bag.write(options.scan_topic, stamp + kArrival + kArrival, messages.scan(step));
    }
    bag.close();
  } catch (const rosbag::BagException& error) {
    throw DriveBagError("bag '" + path + "' cannot be written: " + error.what());
  }
}

}  // namespace map_matcher
