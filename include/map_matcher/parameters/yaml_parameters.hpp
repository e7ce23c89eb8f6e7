/// \file
/// Reads parameters from a YAML file, for programs without ROS.
#pragma once

#include <string>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::parameters {

/// Fills the fields that `parameters` points at from the top-level keys of a YAML file such as config/map_matcher.yaml;
/// what the file does not name keeps its value. Throws std::invalid_argument with the file's name and everything that
/// is wrong with it, joined by "; ": it cannot be read, a value is of the wrong type or out of its range ("name is
/// VALUE, expected RANGE"), or there is no parameter of a name.
void loadYamlParameters(const std::string& path, const ParameterList& parameters);

}  // namespace map_matcher::parameters
