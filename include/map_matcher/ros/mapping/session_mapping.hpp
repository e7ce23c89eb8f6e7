/// \file
/// A session map drawn from messages: what the session_mapper node and the bag reader have in common.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>

#include <map>
#include <optional>
#include <string>

#include "map_matcher/mapping/session_mapper.hpp"

namespace map_matcher::ros_mapping {

/// Options of a SessionMapping, with slam_gmapping's names as parameters. Their ranges stand in parametersOf().
struct SessionMappingOptions {
  mapping::SessionMapperOptions mapper;
  std::string base_frame = "base_link";  ///< tf frame of the robot.
  std::string odom_frame = "odom";       ///< tf frame of the odometry.
  int throttle_scans = 1;                ///< Only every so many-th scan of a laser is looked at.
  double map_update_interval = 5.0;      ///< [s] A map is due when the last one is older than this at a drawn scan.
};

/// The parameters that fill `options`, those of the mapper among them.
parameters::ParameterList parametersOf(SessionMappingOptions& options);

/// The session as of a scan.
struct SessionSnapshot {
  ros::Time stamp;              ///< Of the scan.
  grid::Rigid2 T_session_base;  ///< Pose of the robot at that time.
  grid::Rigid2 T_session_odom;  ///< Correction of the odometry at that time.
  grid::OccupancyGrid map;      ///< In the session frame.
};

/// What became of a message.
struct MappingUpdate {
  mapping::ScanReport report;
  bool new_session = false;                 ///< Time had jumped back: the scan began a new session.
  std::optional<SessionSnapshot> snapshot;  ///< The map, when one is due.
};

/// Takes the robot's poses from tf at the scans' stamps and hands both to a SessionMapper. When the stamps of a laser
/// go back by more than half a second (a bag in a loop) a new session begins. Not thread-safe.
class SessionMapping {
 public:
  /// Throws std::invalid_argument that names every option out of range.
  explicit SessionMapping(const SessionMappingOptions& options);

  /// Takes a scan of one of the robot's lasers, which come in any order. tf must hold odom_frame <- base_frame and
  /// base_frame <- the scan's frame at its stamp, or tf2::TransformException is thrown. Throws MessageError for a scan
  /// that cannot be used, and one that is older than its predecessor of the same laser by up to half a second.
  MappingUpdate addScan(const sensor_msgs::LaserScan& scan, const tf2::BufferCore& tf, std::size_t laser = 0);

  /// Forgets the session: the next scan begins a new one, whatever its stamp.
  void beginNewSession();

  const mapping::SessionMapper& mapper() const { return mapper_; }

  /// The present map; nullopt before the first drawn scan.
  std::optional<SessionSnapshot> snapshot() const;

 private:
  struct Laser {
    int num_scans = 0;
    ros::Time last_scan;  // stamp of the last scan that came
  };

  bool beginSessionIfTimeJumped(const ros::Time& stamp, std::size_t laser);
  bool isThrottled(std::size_t laser);
  bool mapIsDue(const mapping::ScanReport& report, const ros::Time& stamp) const;

  SessionMappingOptions options_;
  mapping::SessionMapper mapper_;
  std::map<std::size_t, Laser> lasers_;
  ros::Time last_used_;  // stamp of the last scan that the mapper took
  std::optional<ros::Time> last_map_;
};

}  // namespace map_matcher::ros_mapping
