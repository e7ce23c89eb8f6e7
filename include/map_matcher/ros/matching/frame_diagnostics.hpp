/// \file
/// Whether tf is a tree.
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

#include "map_matcher/ros/common/diagnostic_report.hpp"
#include "map_matcher/ros/common/frame_parents.hpp"

namespace map_matcher::ros_matching {

/// What two parents of a frame come to, with the names of the frames and of the nodes that say so.
std::string textOf(const ros_common::ContestedFrame& contested);

/// Tells on /diagnostics, and in the log when it begins and ends, that a frame has two parents: the session frame, or
/// odom with amcl beside a mapper. tf then jumps between both, and says nothing about it.
class FrameDiagnostics {
 public:
  /// `contested` names the frames with two parents at present; it is called on the thread that spins.
  FrameDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                   std::function<std::vector<ros_common::ContestedFrame>()> contested);

 private:
  void look();

  std::function<std::vector<ros_common::ContestedFrame>()> contested_;
  std::string told_;  // what is wrong; empty: nothing
  ros_common::DiagnosticReport report_;
};

}  // namespace map_matcher::ros_matching
