/// \file
/// The session_mapper node: scans and tf in, the session map and its place in tf out.
#pragma once

#include <message_filters/subscriber.h>
#include <nav_msgs/GetMap.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <vector>

#include "map_matcher/ros/common/rising_clock.hpp"
#include "map_matcher/ros/mapping/session_mapper_server_options.hpp"

namespace map_matcher::ros_mapping {

/// Serves a session map as slam_gmapping does, where that is not installed:
/// in `scan` (sensor_msgs/LaserScan), or the topics of several lasers, and tf odom_frame <- base_frame <- laser; out
/// `map` (nav_msgs/OccupancyGrid) and `map_metadata`, both latched, the service `dynamic_map` (nav_msgs/GetMap), and tf
/// map_frame -> odom_frame. Other than slam_gmapping it stamps the map with its last scan, answers `dynamic_map` with
/// the map as it is now, broadcasts nothing before the first scan is drawn, and takes scans of any number of beams.
/// When time goes back it says so and begins a new session. It tells when odometry jumps or the walls contradict it,
/// and which laser is silent.
class SessionMapperServer {
 public:
  /// Throws std::invalid_argument, with the name and value of the option, when one cannot be used.
  SessionMapperServer(ros::NodeHandle node, const ros::NodeHandle& private_node,
                      const SessionMapperServerOptions& options);

 private:
  using ScanFilter = tf2_ros::MessageFilter<sensor_msgs::LaserScan>;

  /// A laser of the robot.
  struct Laser {
    message_filters::Subscriber<sensor_msgs::LaserScan> subscriber;
    std::unique_ptr<ScanFilter> filter;
    int taken = 0;        // scans since the last word about what is missing
    bool silent = false;  // as was told
  };

  void subscribe(ros::NodeHandle& node);
  void onScan(std::size_t laser, const sensor_msgs::LaserScanConstPtr& scan);
  bool onGetMap(nav_msgs::GetMap::Response& response) const;
  void onTick();
  void tellWhatIsMissing();
  void tellWhichLasersAreSilent();

  void tell(const MappingUpdate& update) const;
  void publish(const SessionSnapshot& snapshot);
  nav_msgs::OccupancyGrid messageOf(const SessionSnapshot& snapshot) const;

  const SessionMapperServerOptions options_;
  SessionMapping mapping_;
  ros_common::RisingClock clock_;
  int scans_taken_ = 0;
  int scans_dropped_ = 0;

  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  tf2_ros::TransformBroadcaster tf_broadcaster_;
  ros::Publisher map_publisher_;
  ros::Publisher metadata_publisher_;
  ros::ServiceServer map_service_;
  std::vector<std::unique_ptr<Laser>> lasers_;
  ros::Time last_look_;  // for silent lasers
  ros::Timer tick_timer_;
  ros::WallTimer waiting_timer_;
};

}  // namespace map_matcher::ros_mapping
