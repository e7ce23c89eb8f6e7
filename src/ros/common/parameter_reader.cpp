#include "map_matcher/ros/common/parameter_reader.hpp"

#include <ros/param.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <type_traits>

#include "map_matcher/parameters/nearest_name.hpp"

namespace map_matcher::ros_common {
namespace {

using XmlRpc::XmlRpcValue;

/// A value of the parameter server as it would stand in YAML.
std::string textOf(const XmlRpcValue& value) {
  std::ostringstream text;
  XmlRpcValue copy = value;  // its conversions are not const
  switch (value.getType()) {
    case XmlRpcValue::TypeString:
      text << '"' << static_cast<std::string&>(copy) << '"';
      break;
    case XmlRpcValue::TypeBoolean:
      text << (static_cast<bool&>(copy) ? "true" : "false");
      break;
    case XmlRpcValue::TypeDouble:
      text << static_cast<double&>(copy);
      text << (text.str().find_first_not_of("-0123456789") == std::string::npos ? ".0" : "");
      break;
    case XmlRpcValue::TypeArray:
      text << "a list";
      break;
    case XmlRpcValue::TypeStruct:
      text << "a group of parameters";
      break;
    default:
      value.write(text);
  }
  return text.str();
}

std::optional<std::vector<std::string>> listOfTexts(XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeArray) {
    return std::nullopt;
  }
  std::vector<std::string> texts;
  for (int i = 0; i < value.size(); ++i) {  // NOLINT(modernize-loop-convert): a list has no begin and end
    XmlRpcValue& item = value[i];
    if (item.getType() != XmlRpcValue::TypeString) {
      return std::nullopt;
    }
    texts.push_back(static_cast<std::string&>(item));
  }
  return texts;
}

std::optional<std::map<std::string, std::string>> textsByName(XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeStruct) {
    return std::nullopt;
  }
  std::map<std::string, std::string> texts;
  for (auto& [name, text] : value) {
    if (text.getType() != XmlRpcValue::TypeString) {
      return std::nullopt;
    }
    texts.emplace(name, static_cast<std::string&>(text));
  }
  return texts;
}

/// The value as a T, or nothing when it is of another type; a whole number serves as a double.
template <typename T>
std::optional<T> as(const XmlRpcValue& value) {
  XmlRpcValue copy = value;  // its conversions are not const
  const XmlRpcValue::Type type = value.getType();
  if constexpr (std::is_same_v<T, bool>) {
    return type == XmlRpcValue::TypeBoolean ? std::optional<T>(static_cast<bool&>(copy)) : std::nullopt;
  } else if constexpr (std::is_same_v<T, std::string>) {
    return type == XmlRpcValue::TypeString ? std::optional<T>(static_cast<std::string&>(copy)) : std::nullopt;
  } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    return listOfTexts(copy);
  } else if constexpr (std::is_same_v<T, std::map<std::string, std::string>>) {
    return textsByName(copy);
  } else {
    if (type == XmlRpcValue::TypeInt) {
      return static_cast<T>(static_cast<int&>(copy));
    }
    if constexpr (std::is_same_v<T, double>) {
      return type == XmlRpcValue::TypeDouble ? std::optional<T>(static_cast<double&>(copy)) : std::nullopt;
    }
    return std::nullopt;
  }
}

const char* typeText(const parameters::Parameter& parameter) {
  if (std::holds_alternative<bool*>(parameter.value) ||
      std::holds_alternative<std::vector<std::string>*>(parameter.value) ||
      std::holds_alternative<std::map<std::string, std::string>*>(parameter.value)) {
    return "";  // its range says it
  }
  if (std::holds_alternative<int*>(parameter.value)) {
    return "a whole number: ";
  }
  return std::holds_alternative<double*>(parameter.value) ? "a number: " : "a text: ";
}

std::string wrongType(const parameters::Parameter& parameter, const XmlRpcValue& value) {
  return parameter.name + " is " + textOf(value) + ", expected " + typeText(parameter) +
         parameters::rangeText(parameter) + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

/// Writes `value` to the parameter's field unless it is of a wrong type or out of range, which it tells.
std::string assign(const parameters::Parameter& parameter, const XmlRpcValue& value) {
  return std::visit(
      [&](auto* field) -> std::string {
        using Field = std::remove_pointer_t<decltype(field)>;
        const std::optional<Field> typed = as<Field>(value);
        if (!typed) {
          return wrongType(parameter, value);
        }
        const Field before = *field;
        *field = *typed;
        std::string problem = parameters::problemWith(parameter);
        if (!problem.empty()) {
          *field = before;
        }
        return problem;
      },
      parameter.value);
}

}  // namespace

std::vector<std::string> readParameters(const ros::NodeHandle& node, const parameters::ParameterList& parameters) {
  std::vector<std::string> problems;
  for (const parameters::Parameter& parameter : parameters) {
    XmlRpcValue value;
    if (!node.getParam(parameter.name, value)) {
      continue;
    }
    const std::string problem = assign(parameter, value);
    if (!problem.empty()) {
      problems.push_back("~" + problem);
    }
  }
  return problems;
}

std::vector<std::string> unknownParameters(const ros::NodeHandle& node, const parameters::ParameterList& parameters) {
  XmlRpcValue all;
  std::vector<std::string> unknown;
  if (!ros::param::get(node.getNamespace(), all) || all.getType() != XmlRpcValue::TypeStruct) {
    return unknown;
  }
  for (const auto& [name, value] : all) {
    const auto has_name = [&name = name](const parameters::Parameter& parameter) { return parameter.name == name; };
    if (std::any_of(parameters.begin(), parameters.end(), has_name)) {
      continue;
    }
    const std::optional<std::string> nearest = parameters::nearestName(name, parameters);
    unknown.push_back("~" + name + " is " + textOf(value) + ", but there is no such parameter" +
                      (nearest ? "; did you mean ~" + *nearest + "?" : ""));
  }
  return unknown;
}

}  // namespace map_matcher::ros_common
