#include "map_matcher/ros/simulation/crowd_simulator_server.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/param.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/run_node.hpp"

namespace map_matcher::ros_simulation {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::uint32_t kQueue = 10;
constexpr std::uint32_t kManyQueue = 100;            // of tf, as tf2's own broadcaster, and of the clock
const ros::Duration kTick(0.01);                     // the clock advances by no more
constexpr double kLostBetweenWarnings = 5.0;         // [s]
constexpr std::chrono::milliseconds kFarewell(500);  // for the last messages to get through

DriveMessageOptions messageOptionsOf(const CrowdSimulatorServerOptions& options) {
  DriveMessageOptions messages;
  messages.score_threshold = options.drive.detector.score_threshold;
  messages.map_frame = ros_common::frameName(options.map_frame);
  messages.odometry_frame = ros_common::frameName(options.odom_frame);
  messages.base_frame = ros_common::frameName(options.base_frame);
  messages.lidars = lidarNames(options.rear_lidar ? 2 : 1);
  return messages;
}

/// The options, unless two frames have the same name, or none.
const CrowdSimulatorServerOptions& checked(const CrowdSimulatorServerOptions& options) {
  const DriveMessageOptions messages = messageOptionsOf(options);
  std::set<std::string> taken{""};
  for (const LidarNames& lidar : messages.lidars) {
    taken.insert(lidar.frame);
  }
  for (const auto& [name, frame] :
       {std::pair("map_frame", messages.map_frame), std::pair("odom_frame", messages.odometry_frame),
        std::pair("base_frame", messages.base_frame)}) {
    if (!taken.insert(frame).second) {
      throw std::invalid_argument("~" + std::string(name) + " is \"" + frame +
                                  "\", expected a name that no other frame has");
    }
  }
  return options;
}

DriveDescription descriptionOf(const simulation::DriveSimulation& simulation,
                               const CrowdSimulatorServerOptions& options) {
  return {simulation.lidarPoses(), 1.0 / options.drive.rate};
}

}  // namespace

CrowdSimulatorServer::CrowdSimulatorServer(const ros::NodeHandle& node, const ros::NodeHandle& /*private_node*/,
                                           const CrowdSimulatorServerOptions& options)
    : CrowdSimulatorServer(node, checked(options), mapOf(options)) {}

CrowdSimulatorServer::CrowdSimulatorServer(ros::NodeHandle node, const CrowdSimulatorServerOptions& options,
                                           const grid::OccupancyGrid& map)
    : options_(options),
      simulation_(map, driveOf(options)),
      messages_(descriptionOf(simulation_, options), messageOptionsOf(options)),
      clock_(messages_.stampAt(0.0)),
      pacing_(options.real_time_factor) {
  advertise(node, map);
  if (!ros::param::param("/use_sim_time", false)) {
    ROS_WARN("/use_sim_time is not true, expected true: nodes that were started without it do not go by /clock");
  }
  thread_ = std::thread([this] { run(); });
}

CrowdSimulatorServer::~CrowdSimulatorServer() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
  }
  stop_.notify_all();
  thread_.join();
}

void CrowdSimulatorServer::advertise(ros::NodeHandle& node, const grid::OccupancyGrid& map) {
  const DriveMessageOptions& names = messages_.options();
  clock_publisher_ = node.advertise<rosgraph_msgs::Clock>("/clock", kManyQueue);
  map_publisher_ = node.advertise<nav_msgs::OccupancyGrid>("true_map", 1, true);
  map_publisher_.publish(ros_common::toMessage(map, names.map_frame, clock_));
  const char* tf = DriveMessages::kTransformTopic;
  publishers_[tf] = node.advertise<tf2_msgs::TFMessage>(tf, kManyQueue);
  publishers_[names.odometry_topic] = node.advertise<nav_msgs::Odometry>(names.odometry_topic, kQueue);
  publishers_[names.truth_topic] = node.advertise<geometry_msgs::PoseStamped>(names.truth_topic, kQueue);
  for (const LidarNames& lidar : names.lidars) {
    publishers_[lidar.scan_topic] = node.advertise<sensor_msgs::LaserScan>(lidar.scan_topic, kQueue);
  }
  if (!simulation_.hasPeople()) {
    return;
  }
  publishers_[names.people_topic] = node.advertise<geometry_msgs::PoseArray>(names.people_topic, kQueue);
  for (const LidarNames& lidar : names.lidars) {
    publishers_[lidar.detections_topic] = node.advertise<geometry_msgs::PoseArray>(lidar.detections_topic, kQueue);
    publishers_[lidar.scored_detections_topic] =
        node.advertise<PersonDetections>(lidar.scored_detections_topic, kQueue);
  }
}

/// The thread.
void CrowdSimulatorServer::run() {
  try {
    waitUntil(SteadyClock::now() + std::chrono::milliseconds(std::lround(1000.0 * options_.start_delay)));
    drive();
    waitUntil(SteadyClock::now() + kFarewell);
  } catch (const std::exception& error) {
    ros_common::logFatal(error);
  }
  ros::requestShutdown();
}

/// Until it is over, or stopped. Each step is simulated while the one before it is shown.
void CrowdSimulatorServer::drive() {
  std::uint32_t number = 0;
  double time = 0.0;
  for (auto step = simulation_.next(); step && !isStopped(); step = simulation_.next()) {
    if (number == 0) {
      ROS_INFO_STREAM("the drive begins, among " << step->people.size() << " people");
    }
    time = step->time;
    advanceTo(messages_.stampAt(time));
    messages_.visit(*step, number++, [&](const std::string& topic, const ros::Time& arrival, const auto& message) {
      on_their_way_.emplace(arrival, [message, &publisher = publishers_.at(topic)] { publisher.publish(message); });
    });
    deliver();
  }
  while (!on_their_way_.empty() && !isStopped()) {
    advanceTo(on_their_way_.begin()->first);
  }
  if (!isStopped()) {
    ROS_INFO_STREAM("the drive is over after " << time << " s");
  }
}

/// Lets simulated time pass, and publishes what arrives.
void CrowdSimulatorServer::advanceTo(const ros::Time& time) {
  while (clock_ < time && !isStopped()) {
    ros::Time next = std::min(time, clock_ + kTick);
    if (!on_their_way_.empty()) {
      next = std::min(next, on_their_way_.begin()->first);
    }
    waitUntil(pacing_.dueAfter((next - clock_).toSec(), SteadyClock::now()));
    clock_ = next;
    deliver();
  }
  tellIfSlow();
}

/// The time, and what has arrived by now.
void CrowdSimulatorServer::deliver() {
  rosgraph_msgs::Clock message;
  message.clock = clock_;
  clock_publisher_.publish(message);
  const auto end = on_their_way_.upper_bound(clock_);
  std::for_each(on_their_way_.begin(), end, [](const auto& arrived) { arrived.second(); });
  on_their_way_.erase(on_their_way_.begin(), end);
}

/// Returns at once when the drive is stopped.
void CrowdSimulatorServer::waitUntil(const ros_common::Pacing::TimePoint& time) {
  std::unique_lock<std::mutex> lock(mutex_);
  stop_.wait_until(lock, time, [this] { return stopped_; });
}

void CrowdSimulatorServer::tellIfSlow() {
  if (pacing_.lost() < told_lost_ + kLostBetweenWarnings) {
    return;
  }
  told_lost_ = pacing_.lost();
  ROS_WARN_STREAM("simulated time is " << told_lost_ << " s behind real_time_factor " << options_.real_time_factor
                                       << ": this machine simulates no faster; expected fewer people, beams or lidars, "
                                          "a lower rate or a smaller real_time_factor");
}

bool CrowdSimulatorServer::isStopped() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopped_;
}

}  // namespace map_matcher::ros_simulation
