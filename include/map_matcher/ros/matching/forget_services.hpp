/// \file
/// Forgetting on request.
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Empty.h>

#include <functional>
#include <string>

namespace map_matcher::ros_matching {

/// Serves `global_localization`, the name that amcl and its kin share for "forget where you are and find yourself", and
/// `~reset`, which does the same.
class ForgetServices {
 public:
  /// `forget` is called on the thread that spins, with the name of the service that was called.
  ForgetServices(ros::NodeHandle node, ros::NodeHandle private_node,
                 std::function<void(const std::string& service)> forget);

 private:
  ros::ServiceServer global_localization_;
  ros::ServiceServer reset_;
};

}  // namespace map_matcher::ros_matching
