/// \file
/// The crowd_simulator node: a robot that drives among people, as its topics and tf.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "map_matcher/ros/common/pacing.hpp"
#include "map_matcher/ros/simulation/crowd_simulator_server_options.hpp"
#include "map_matcher/ros/simulation/drive_messages.hpp"

namespace map_matcher::ros_simulation {

/// Simulates a drive and publishes its messages (DriveMessages) when they arrive, beside `/clock`
/// (rosgraph_msgs/Clock): scans, `odom`, tf, `ground_truth` and, where there are people, `people_truth` and detections.
/// `true_map` (nav_msgs/OccupancyGrid, latched) is the map that is driven in. All other nodes need /use_sim_time.
///
/// The clock advances by 10 ms at most and never skips anything. Where a machine simulates slower than
/// real_time_factor asks for, the simulated clock falls behind the real one and a warning says so. The same options
/// give the same messages, however fast. At the end of the drive the node is shut down.
class CrowdSimulatorServer {
 public:
  /// Throws std::invalid_argument that names each option that cannot be used, MapFileError for a map that cannot be
  /// read.
  CrowdSimulatorServer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                       const CrowdSimulatorServerOptions& options);

  /// Ends the drive.
  ~CrowdSimulatorServer();
  CrowdSimulatorServer(const CrowdSimulatorServer&) = delete;
  CrowdSimulatorServer& operator=(const CrowdSimulatorServer&) = delete;

 private:
  CrowdSimulatorServer(ros::NodeHandle node, const CrowdSimulatorServerOptions& options,
                       const grid::OccupancyGrid& map);
  void advertise(ros::NodeHandle& node, const grid::OccupancyGrid& map);
  void run();
  void drive();
  void advanceTo(const ros::Time& time);
  void deliver();
  void waitUntil(const ros_common::Pacing::TimePoint& time);
  void tellIfSlow();
  bool isStopped();

  const CrowdSimulatorServerOptions options_;
  simulation::DriveSimulation simulation_;
  DriveMessages messages_;
  ros::Publisher map_publisher_;
  ros::Publisher clock_publisher_;
  std::map<std::string, ros::Publisher> publishers_;              // by their topic
  std::multimap<ros::Time, std::function<void()>> on_their_way_;  // publish a message each, by arrival
  ros::Time clock_;
  ros_common::Pacing pacing_;
  double told_lost_ = 0.0;  // [s] that a warning was about

  std::mutex mutex_;  // guards stopped_
  std::condition_variable stop_;
  bool stopped_ = false;
  std::thread thread_;  // last, so that it starts when all else is there
};

}  // namespace map_matcher::ros_simulation
