/// \file
/// Reads parameters from the ROS parameter server into options structs.
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::ros_common {

/// Fills the fields that `parameters` points at from the private parameters of `node`; what is not set keeps its value.
/// Returns one line for each parameter of a wrong type or out of its range: "~name is VALUE, expected RANGE"; its field
/// keeps its value. A whole number serves as a double, but not the other way round.
std::vector<std::string> readParameters(const ros::NodeHandle& node, const parameters::ParameterList& parameters);

/// One line for each name set under `node` that is not in `parameters`, most likely a misspelt one: "~name is VALUE,
/// but there is no such parameter; did you mean ~NAME?", the last part when a known name is close.
std::vector<std::string> unknownParameters(const ros::NodeHandle& node, const parameters::ParameterList& parameters);

}  // namespace map_matcher::ros_common
