/// \file
/// The body of every node's main: parameters, server, spin, and what is told when one of them fails.
#pragma once

#include <ros/init.h>
#include <ros/node_handle.h>

#include <exception>
#include <iostream>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::ros_common {

/// Exit code of a program whose parameters or files cannot be used.
constexpr int kExitBadInput = 2;

/// Fills the fields that `parameters` points at and logs every problem: an error for each wrong type or value, a
/// warning for each unknown name. False when there was an error, so that all of them are told before the node gives up.
bool loadParameters(const ros::NodeHandle& private_node, const parameters::ParameterList& parameters);

/// Logs, as fatal, why a node cannot run. Only as long as there is a node handle: without one logging is at its end.
void logFatal(const std::exception& error);

/// Makes SIGTERM an orderly end, as SIGINT is one from the first node handle on.
void shutDownOnTerm();

/// Reads the parameters and serves until the node is shut down; returns the exit code, see runNode().
template <typename Server, typename Options>
int serve(const ros::NodeHandle& node, const ros::NodeHandle& private_node) {
  shutDownOnTerm();
  try {
    Options options;
    if (!loadParameters(private_node, parametersOf(options))) {
      return kExitBadInput;
    }
    const Server server(node, private_node, options);
    ros::spin();
    return 0;
  } catch (const std::exception& error) {
    logFatal(error);
    return kExitBadInput;
  }
}

/// Runs a node until it is shut down, by SIGINT, by SIGTERM or through ROS, and returns the exit code of the process:
/// 0, or kExitBadInput when a parameter or a file that it names cannot be used. `parametersOf(Options&)` lists the
/// parameters; `Server(node, private_node, options)` serves as long as it lives, and throws std::exception when it
/// cannot.
template <typename Server, typename Options>
int runNode(int argc, char** argv, const char* name) {
  try {
    ros::init(argc, argv, name);
    return serve<Server, Options>(ros::NodeHandle(), ros::NodeHandle("~"));
  } catch (const std::exception& error) {  // a name that ROS does not allow
    std::cerr << error.what() << "\n";
    return kExitBadInput;
  }
}

}  // namespace map_matcher::ros_common
