/// \file
/// A simulated drive as the messages of the robot that drives.
#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <map_matcher/PersonDetections.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "map_matcher/simulation/drive.hpp"

namespace map_matcher::ros_simulation {

/// Names of one lidar. Where the drive has people, a detector tells of them twice: as DR-SPAAM does, and with scores.
struct LidarNames {
  std::string scan_topic = "scan";                            ///< sensor_msgs/LaserScan
  std::string detections_topic = "dr_spaam_detections";       ///< geometry_msgs/PoseArray, from score_threshold on.
  std::string scored_detections_topic = "person_detections";  ///< map_matcher/PersonDetections, whatever the score.
  std::string frame = "laser";
};

/// Names of this many lidars: those above of one; of two sick_laser_front and sick_laser_rear, as on the CROWDBOT
/// Pepper, with detections in dr_spaam_detections/front and rear; of more laser_1/scan and so on.
std::vector<LidarNames> lidarNames(std::size_t count);

/// How a drive is told.
struct DriveMessageOptions {
  double start_stamp = 1000.0;                ///< [s] Of the first messages, from 1 to 4e9.
  double score_threshold = 0.4;               ///< Detections with a lower score are left out where there are no scores.
  std::string odometry_topic = "odom";        ///< nav_msgs/Odometry
  std::string truth_topic = "ground_truth";   ///< geometry_msgs/PoseStamped, the base in the map frame.
  std::string people_topic = "people_truth";  ///< geometry_msgs/PoseArray, in the map frame, where there are people.
  std::string map_frame = "map";              ///< Frame of the map that is driven in.
  std::string odometry_frame = "odom";        ///< Where the odometry began.
  std::string base_frame = "base_link";       ///< Of the robot.
  std::vector<LidarNames> lidars;             ///< As many as the drive has lidars; empty: lidarNames().
};

/// What the messages of all steps share.
struct DriveDescription {
  std::vector<grid::Rigid2> T_base_lidar;  ///< Mounting pose of each lidar.
  double period = 0.0;                     ///< [s] Between two steps.
};

/// Turns the steps of a drive into messages, for whoever passes them on. All messages of a step have its stamp, and
/// arrive in this order: /tf with odometry_frame -> base_frame and base_frame -> the frame of each lidar (the fixed
/// mounting is repeated, so that one may begin to listen anywhere); 1 ms later odometry, ground truth and, with people,
/// where they are, with their headings; 2 ms later each scan, when its transform is known. Detections have the stamp
/// and frame of their scan and arrive with their detector's latency, 3 ms after the scan's stamp at the earliest; as
/// DR-SPAAM's their orientation is 0, 0, 0, 0, and an empty array tells that nobody is there. The same steps give the
/// same messages byte for byte.
class DriveMessages {
 public:
  static constexpr const char* kTransformTopic = "/tf";  ///< tf2_msgs/TFMessage

  /// Throws std::invalid_argument when start_stamp is out of its range or the number of names is not that of the
  /// lidars.
  DriveMessages(DriveDescription drive, const DriveMessageOptions& options);

  /// The options, with the names of all lidars.
  const DriveMessageOptions& options() const { return options_; }

  /// The stamp of the messages of a time since the start of the drive [s].
  ros::Time stampAt(double time) const;

  /// Calls `take(topic, arrival, message)` for each message of a step in the order above; `arrival` is a ros::Time.
  /// `number` counts the steps: it becomes the sequence number.
  template <typename Take>
  void visit(const simulation::DriveStep& step, std::uint32_t number, Take&& take) const;

 private:
  struct Source {
    const simulation::DriveStep& step;
    std::uint32_t number;
    ros::Time stamp;
  };

  tf2_msgs::TFMessage transforms(const Source& source) const;
  nav_msgs::Odometry odometry(const Source& source) const;
  geometry_msgs::PoseStamped truth(const Source& source) const;
  geometry_msgs::PoseArray people(const Source& source) const;
  sensor_msgs::LaserScan scan(const Source& source, std::size_t lidar) const;
  geometry_msgs::PoseArray detections(const Source& source, std::size_t lidar) const;
  PersonDetections scoredDetections(const Source& source, std::size_t lidar) const;
  ros::Time arrivalOfDetections(const Source& source, std::size_t lidar) const;

  DriveDescription drive_;
  DriveMessageOptions options_;
};

template <typename Take>
void DriveMessages::visit(const simulation::DriveStep& step, std::uint32_t number, Take&& take) const {
  // Who passes messages on may not keep the order of those that arrive at the same time: the scan must come later than
  // its transform. Three times this is less than the shortest time between two steps.
  const ros::Duration later(0.001);
  const Source source{step, number, stampAt(step.time)};
  take(kTransformTopic, source.stamp, transforms(source));
  take(options_.odometry_topic, source.stamp + later, odometry(source));
  take(options_.truth_topic, source.stamp + later, truth(source));
  const bool has_people = !step.detections.empty();
  if (has_people) {
    take(options_.people_topic, source.stamp + later, people(source));
  }
  for (std::size_t i = 0; i < step.scans.size(); ++i) {
    const LidarNames& names = options_.lidars[i];
    take(names.scan_topic, source.stamp + later + later, scan(source, i));
    if (has_people && step.detections[i]) {
      const ros::Time arrival = arrivalOfDetections(source, i);
      take(names.detections_topic, arrival, detections(source, i));
      take(names.scored_detections_topic, arrival, scoredDetections(source, i));
    }
  }
}

}  // namespace map_matcher::ros_simulation
