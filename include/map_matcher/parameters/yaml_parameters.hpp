/// \file
/// Reads parameters from a YAML file, for programs without ROS.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher {

/// What reading a file brought to light.
struct YamlParametersReport {
  std::vector<std::string> problems;  ///< "name is VALUE, expected RANGE": wrong type or out of range; unreadable file.
  std::vector<std::string> unknown;   ///< Names in the file that are not in the list.
};

/// Fills the fields that `parameters` points at from the top-level keys of a YAML file such as config/map_matcher.yaml;
/// what the file does not name keeps its value.
YamlParametersReport readYamlParameters(const std::string& path, const ParameterList& parameters);

}  // namespace map_matcher
