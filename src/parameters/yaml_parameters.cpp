#include "map_matcher/parameters/yaml_parameters.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <type_traits>

namespace map_matcher {
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

}  // namespace

YamlParametersReport readYamlParameters(const std::string& path, const ParameterList& parameters) {
  YamlParametersReport report;
  YAML::Node root;
  try {
    root = YAML::LoadFile(path);
  } catch (const YAML::Exception& error) {
    report.problems.push_back("parameter file '" + path + "' cannot be read: " + error.what());
    return report;
  }
  if (!root.IsMap() && !root.IsNull()) {
    report.problems.push_back("parameter file '" + path + "' holds no 'name: value' lines");
    return report;
  }
  for (const auto& entry : root) {
    const auto name = entry.first.as<std::string>();
    const auto known = std::find_if(parameters.begin(), parameters.end(),
                                    [&name](const Parameter& parameter) { return parameter.name == name; });
    if (known == parameters.end()) {
      report.unknown.push_back(name);
      continue;
    }
    const std::string problem = assign(*known, entry.second);
    if (!problem.empty()) {
      report.problems.push_back("parameter file '" + path + "': " + problem);
    }
  }
  return report;
}

}  // namespace map_matcher
