/// \file
/// What people tell the node by hand.
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "map_matcher/ros/matching/forget_services.hpp"
#include "map_matcher/ros/matching/initial_pose_source.hpp"

namespace map_matcher::ros_matching {

/// Listens to initialpose, global_localization and ~reset. For the thread that spins.
class OperatorHand {
 public:
  /// What is done about it.
  struct Actions {
    MapsLookup maps;
    std::function<void(const belief::Prior&)> suppose;       ///< The session lies there, says an operator.
    std::function<void(const std::string& service)> forget;  ///< All that is believed is to be forgotten.
  };

  /// `robot` must outlive this.
  OperatorHand(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const RobotPoseSource& robot,
               const Actions& actions)
      : initial_pose_(node, robot, actions.maps, actions.suppose), forget_(node, private_node, actions.forget) {}

  /// Hands over what waits; to be called again and again.
  void tick(const ros::Time& now) { initial_pose_.handOver(now); }

 private:
  InitialPoseSource initial_pose_;
  ForgetServices forget_;
};

}  // namespace map_matcher::ros_matching
