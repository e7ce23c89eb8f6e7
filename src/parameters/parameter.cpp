#include "map_matcher/parameters/parameter.hpp"

#include <algorithm>
#include <cmath>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::parameters {
namespace {

using TextsByName = std::map<std::string, std::string>;

bool numberInRange(double value, const Parameter& parameter) {
  return std::isfinite(value) && value >= parameter.min && value <= parameter.max;
}

bool isAllowed(const Parameter& parameter) {
  if (const auto* const* number = std::get_if<int*>(&parameter.value)) {
    return numberInRange(**number, parameter);
  }
  if (const auto* const* number = std::get_if<double*>(&parameter.value)) {
    return numberInRange(**number, parameter);
  }
  if (const auto* const* text = std::get_if<std::string*>(&parameter.value)) {
    const auto& choices = parameter.choices;
    return choices.empty() || std::find(choices.begin(), choices.end(), **text) != choices.end();
  }
  return true;
}

std::string numericRangeText(const Parameter& parameter) {
  const bool has_min = std::isfinite(parameter.min);
  const bool has_max = std::isfinite(parameter.max);
  if (has_min && has_max) {
    return numberText(parameter.min) + " to " + numberText(parameter.max);
  }
  if (has_min) {
    return "at least " + numberText(parameter.min);
  }
  return has_max ? "at most " + numberText(parameter.max) : "any number";
}

}  // namespace

std::string valueText(const Parameter& parameter) {
  if (const auto* const* flag = std::get_if<bool*>(&parameter.value)) {
    return **flag ? "true" : "false";
  }
  if (const auto* const* number = std::get_if<int*>(&parameter.value)) {
    return std::to_string(**number);
  }
  if (const auto* const* number = std::get_if<double*>(&parameter.value)) {
    return numberText(**number);
  }
  if (const auto* const* text = std::get_if<std::string*>(&parameter.value)) {
    return "\"" + **text + "\"";
  }
  std::string list;
  if (const auto* const* texts = std::get_if<std::vector<std::string>*>(&parameter.value)) {
    for (const std::string& text : **texts) {
      list += (list.empty() ? "\"" : ", \"") + text + "\"";
    }
    return "[" + list + "]";
  }
  for (const auto& [name, text] : **std::get_if<TextsByName*>(&parameter.value)) {
    list += (list.empty() ? "" : ", ") + name + ": \"" + text + "\"";
  }
  return "{" + list + "}";
}

std::string rangeText(const Parameter& parameter) {
  if (std::holds_alternative<bool*>(parameter.value)) {
    return "true | false";
  }
  if (std::holds_alternative<std::vector<std::string>*>(parameter.value)) {
    return "a list of texts";
  }
  if (std::holds_alternative<TextsByName*>(parameter.value)) {
    return "texts by name";
  }
  if (!std::holds_alternative<std::string*>(parameter.value)) {
    return numericRangeText(parameter);
  }
  std::string text;
  for (const std::string& choice : parameter.choices) {
    text += (text.empty() ? "" : " | ") + choice;
  }
  return text.empty() ? "any text" : text;
}

std::string problemWith(const Parameter& parameter) {
  if (isAllowed(parameter)) {
    return "";
  }
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  return parameter.name + " is " + valueText(parameter) + ", expected " + rangeText(parameter) + unit;
}

}  // namespace map_matcher::parameters
