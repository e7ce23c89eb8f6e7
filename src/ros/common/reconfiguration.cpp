#include "map_matcher/ros/common/reconfiguration.hpp"

#include <ros/console.h>

#include <algorithm>
#include <type_traits>
#include <variant>

#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::ros_common {
namespace {

template <typename Entries, typename Value>
void append(Entries& entries, const std::string& name, const Value& value) {
  entries.emplace_back();
  entries.back().name = name;
  entries.back().value = value;
}

template <typename Entries, typename Value>
void assign(const Entries& entries, const std::string& name, Value& value) {
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.name == name; });
  if (entry != entries.end()) {
    value = static_cast<Value>(entry->value);
  }
}

/// Calls `visit` with the entries of `config` that hold values of the parameter's type, and with the field.
template <typename Config, typename Visit>
void visitEntries(Config& config, const parameters::Parameter& parameter, const Visit& visit) {
  std::visit(
      [&](auto* field) {
        using Value = std::remove_pointer_t<decltype(field)>;
        if constexpr (std::is_same_v<Value, bool>) {
          visit(config.bools, *field);
        } else if constexpr (std::is_same_v<Value, int>) {
          visit(config.ints, *field);
        } else if constexpr (std::is_same_v<Value, double>) {
          visit(config.doubles, *field);
        } else if constexpr (std::is_same_v<Value, std::string>) {
          visit(config.strs, *field);
        }
      },
      parameter.value);
}

}  // namespace

dynamic_reconfigure::Config configOf(const parameters::ParameterList& parameters) {
  dynamic_reconfigure::Config config;
  for (const parameters::Parameter& parameter : parameters) {
    visitEntries(config, parameter, [&](auto& entries, const auto& value) { append(entries, parameter.name, value); });
  }
  return config;
}

std::vector<std::string> takeFrom(const dynamic_reconfigure::Config& config,
                                  const parameters::ParameterList& parameters) {
  std::vector<std::string> changes;
  for (const parameters::Parameter& parameter : parameters) {
    const std::string before = parameters::valueText(parameter);
    visitEntries(config, parameter, [&](const auto& entries, auto& value) { assign(entries, parameter.name, value); });
    const std::string now = parameters::valueText(parameter);
    if (now != before) {
      changes.push_back(parameter.name + " is " + now + " now, and was " + before);
    }
  }
  parameters::throwIfAny(parameters::problemsOf(parameters));
  return changes;
}

void tellOfChange(const std::string& change) { ROS_INFO_STREAM("reconfigured: " << change); }

void tellOfRefusal(const std::string& reason) {
  ROS_ERROR_STREAM("not reconfigured, all parameters stay as they are: " << reason);
}

}  // namespace map_matcher::ros_common
