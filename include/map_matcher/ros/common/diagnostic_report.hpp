/// \file
/// What every node's report on /diagnostics has in common.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/console.h>
#include <ros/node_handle.h>

#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "map_matcher/ros/common/diagnostic_levels.hpp"

namespace map_matcher::ros_common {

/// Once a second, by the wall clock, publishes a status for each thing that there is to tell, under the node's name.
class DiagnosticReport {
 public:
  /// Writes one status.
  using Tell = std::function<void(diagnostic_updater::DiagnosticStatusWrapper&)>;

  /// `before_each`, if not null, is called before the statuses of a report are written. All callbacks are called on the
  /// thread that spins.
  DiagnosticReport(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                   std::function<void()> before_each = nullptr)
      : before_each_(std::move(before_each)), updater_(node, private_node, private_node.getNamespace()) {
    updater_.setHardwareID("none");
    timer_ = node.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent& /*event*/) { publish(); });
  }
  DiagnosticReport(const DiagnosticReport&) = delete;
  DiagnosticReport& operator=(const DiagnosticReport&) = delete;

  /// Adds a status to all reports from now on.
  void add(const std::string& name, const Tell& tell) {
    updater_.add(name, [tell](diagnostic_updater::DiagnosticStatusWrapper& status) { tell(status); });
  }

 private:
  /// A report that fails is no reason for a node to end.
  void publish() {
    try {
      if (before_each_) {
        before_each_();
      }
      updater_.force_update();
    } catch (const std::exception& error) {
      ROS_ERROR_STREAM_THROTTLE(5.0, "/diagnostics fails: " << error.what());
    }
  }

  std::function<void()> before_each_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace map_matcher::ros_common
