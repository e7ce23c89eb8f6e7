#include "map_matcher/parameters/yaml_parameters.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "map_matcher/parameters/nearest_name.hpp"
#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::parameters {
namespace {

/// Stores a YAML value in a parameter's field; returns the problem, or "".
std::string assign(const Parameter& parameter, const YAML::Node& node) {
  try {
    std::visit([&node](auto* field) { *field = node.as<std::decay_t<decltype(*field)>>(); }, parameter.value);
  } catch (const YAML::Exception&) {
    return parameter.name + " is " + YAML::Dump(node) + ", expected " + rangeText(parameter);
  }
  return problemWith(parameter);
}

/// Stores one entry of the file; returns the problem, or "".
std::string take(const std::string& name, const YAML::Node& value, const ParameterList& parameters) {
  const auto known = std::find_if(parameters.begin(), parameters.end(),
                                  [&name](const Parameter& parameter) { return parameter.name == name; });
  if (known != parameters.end()) {
    return assign(*known, value);
  }
  const std::optional<std::string> nearest = nearestName(name, parameters);
  return "there is no parameter " + name + (nearest ? "; did you mean " + *nearest + "?" : "");
}

YAML::Node readFile(const std::string& path) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(path);
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument("parameter file '" + path + "' cannot be read: " + error.what());
  }
  if (!root.IsMap() && !root.IsNull()) {
    throw std::invalid_argument("parameter file '" + path + "' holds no 'name: value' lines");
  }
  return root;
}

}  // namespace

void loadYamlParameters(const std::string& path, const ParameterList& parameters) {
  std::vector<std::string> problems;
  for (const auto& entry : readFile(path)) {
    const std::string problem = take(entry.first.as<std::string>(), entry.second, parameters);
    if (!problem.empty()) {
      problems.push_back((problems.empty() ? "parameter file '" + path + "': " : "") + problem);
    }
  }
  throwIfAny(problems);
}

}  // namespace map_matcher::parameters
