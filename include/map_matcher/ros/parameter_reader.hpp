/// \file
/// Reads parameters from the ROS parameter server into options structs.
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher {

/// Fills the fields that `parameters` points at from the private parameters of `node`; what is not set keeps its value.
/// Returns one line for each parameter of a wrong type or out of its range: "~name is VALUE, expected RANGE".
std::vector<std::string> readParameters(const ros::NodeHandle& node, const ParameterList& parameters);

/// Names set under `node` that are not in `parameters`, each with the nearest known name when one is close: misspelt
/// ones.
std::vector<std::string> unknownParameters(const ros::NodeHandle& node, const ParameterList& parameters);

}  // namespace map_matcher
