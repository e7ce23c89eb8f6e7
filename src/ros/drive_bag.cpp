#include "map_matcher/ros/drive_bag.hpp"

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "map_matcher/ros/conversions.hpp"

namespace map_matcher {
namespace {

/// [s] A bag does not keep the order of messages that arrived at the same time: the scan must come later than its
/// transform. Twice this is less than the shortest time between two scans.
const ros::Duration kArrival(0.001);

ros::Time stampAt(double start, double time) {
  ros::Duration since_start;
  since_start.fromNSec(std::llround(time * 1e9));
  return ros::Time(start) + since_start;
}

/// The messages of one step.
class StepMessages {
 public:
  StepMessages(const DriveStep& step, std::uint32_t number, const DriveDescription& drive,
               const DriveBagOptions& options)
      : step_(step),
        number_(number),
        drive_(drive),
        options_(options),
        stamp_(stampAt(options.start_stamp, step.time)) {}

  const ros::Time& stamp() const { return stamp_; }

  sensor_msgs::LaserScan scan(std::size_t lidar) const {
    const PlanarScan& scan = step_.scans[lidar];
    sensor_msgs::LaserScan message;
    message.header = header(options_.lidars[lidar].frame);
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

  nav_msgs::Odometry odometry() const {
    nav_msgs::Odometry message;
    message.header = header(options_.odometry_frame);
    message.child_frame_id = options_.base_frame;
    message.pose.pose = toPoseMessage(step_.T_odom_base);
    message.twist.twist.linear.x = step_.velocity.linear;
    message.twist.twist.angular.z = step_.velocity.angular;
    return message;
  }

  geometry_msgs::PoseStamped truth() const {
    geometry_msgs::PoseStamped message;
    message.header = header(options_.map_frame);
    message.pose = toPoseMessage(step_.T_map_base);
    return message;
  }

  geometry_msgs::PoseArray people() const {
    geometry_msgs::PoseArray message;
    message.header = header(options_.map_frame);
    for (const Person& person : step_.people) {
      message.poses.push_back(toPoseMessage({person.position.x(), person.position.y(), person.heading}));
    }
    return message;
  }

  geometry_msgs::PoseArray detections(std::size_t lidar) const {
    geometry_msgs::PoseArray message;
    message.header = header(options_.lidars[lidar].frame);
    for (const DetectedPerson& detection : step_.detections[lidar]->people) {
      if (detection.score >= options_.score_threshold) {
        message.poses.emplace_back();
        message.poses.back().position.x = detection.position.x();
        message.poses.back().position.y = detection.position.y();
      }
    }
    return message;
  }

  /// When the detections in a lidar's scan are there.
  ros::Time arrivalOf(std::size_t lidar) const {
    const ros::Time earliest = stamp_ + kArrival + kArrival + kArrival;
    return std::max(earliest, stampAt(options_.start_stamp, step_.detections[lidar]->arrival));
  }

  tf2_msgs::TFMessage transforms() const {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform(options_.odometry_frame, options_.base_frame, step_.T_odom_base));
    for (std::size_t i = 0; i < drive_.T_base_lidar.size(); ++i) {
      message.transforms.push_back(transform(options_.base_frame, options_.lidars[i].frame, drive_.T_base_lidar[i]));
    }
    return message;
  }

 private:
  geometry_msgs::TransformStamped transform(const std::string& parent, const std::string& child,
                                            const Rigid2& T_parent_child) const {
    geometry_msgs::TransformStamped message;
    message.header = header(parent);
    message.child_frame_id = child;
    message.transform = toTransformMessage(T_parent_child);
    return message;
  }

  std_msgs::Header header(const std::string& frame) const {
    std_msgs::Header header;
    header.seq = number_;
    header.stamp = stamp_;
    header.frame_id = frame;
    return header;
  }

  const DriveStep& step_;
  std::uint32_t number_;
  const DriveDescription& drive_;
  const DriveBagOptions& options_;
  ros::Time stamp_;
};

void checkOptions(const DriveBagOptions& options, std::size_t num_lidars) {
  constexpr double kFirst = 1.0;  // rosbag refuses a stamp of 0
  constexpr double kLast = 4e9;   // ros::Time counts seconds in 32 bits
  if (!(options.start_stamp >= kFirst && options.start_stamp <= kLast)) {
    throw DriveBagError("start_stamp is " + std::to_string(options.start_stamp) + ", expected 1 to 4e9 s");
  }
  if (options.lidars.size() != num_lidars) {
    throw DriveBagError("there are names for " + std::to_string(options.lidars.size()) + " lidars, expected " +
                        std::to_string(num_lidars));
  }
}

/// Runs `access`; what rosbag throws becomes an error that names the file.
template <typename Access>
void accessBag(const std::string& path, const Access& access) {
  try {
    access();
  } catch (const rosbag::BagException& error) {
    throw DriveBagError("bag '" + path + "' cannot be written: " + error.what());
  }
}

}  // namespace

std::vector<LidarNames> lidarNames(std::size_t count) {
  if (count == 1) {
    return {LidarNames{}};
  }
  if (count == 2) {
    return {{"/sick_laser_front/scan", "/dr_spaam_detections/front", "sick_laser_front"},
            {"/sick_laser_rear/scan", "/dr_spaam_detections/rear", "sick_laser_rear"}};
  }
  std::vector<LidarNames> names;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string name = "laser_" + std::to_string(i);
    names.push_back({"/" + name + "/scan", "/dr_spaam_detections/" + name, name});
  }
  return names;
}

DriveBagWriter::DriveBagWriter(const std::string& path, DriveDescription drive, const DriveBagOptions& options)
    : path_(path), drive_(std::move(drive)), options_(options) {
  if (options_.lidars.empty()) {
    options_.lidars = lidarNames(drive_.T_base_lidar.size());
  }
  checkOptions(options_, drive_.T_base_lidar.size());
  accessBag(path_, [&] { bag_.open(path_, rosbag::bagmode::Write); });
}

void DriveBagWriter::write(const DriveStep& step) {
  const StepMessages messages(step, num_steps_++, drive_, options_);
  const ros::Time stamp = messages.stamp();
  accessBag(path_, [&] {
    bag_.write("/tf", stamp, messages.transforms());
    bag_.write(options_.odometry_topic, stamp + kArrival, messages.odometry());
    bag_.write(options_.truth_topic, stamp + kArrival, messages.truth());
    const bool has_people = !step.detections.empty();
    if (has_people) {
      bag_.write(options_.people_topic, stamp + kArrival, messages.people());
    }
    for (std::size_t i = 0; i < step.scans.size(); ++i) {
      bag_.write(options_.lidars[i].scan_topic, stamp + kArrival + kArrival, messages.scan(i));
      if (has_people && step.detections[i]) {
        bag_.write(options_.lidars[i].detections_topic, messages.arrivalOf(i), messages.detections(i));
      }
    }
  });
}

void DriveBagWriter::close() {
  accessBag(path_, [&] { bag_.close(); });
}

void writeDriveBag(const Drive& drive, const std::string& path, const DriveBagOptions& options) {
  const double period = drive.steps.size() > 1 ? drive.steps[1].time : 0.0;
  DriveBagWriter writer(path, {drive.T_base_lidar, period}, options);
  for (const DriveStep& step : drive.steps) {
    writer.write(step);
  }
  writer.close();
}

}  // namespace map_matcher
