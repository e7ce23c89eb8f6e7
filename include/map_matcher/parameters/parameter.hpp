/// \file
/// One description of every parameter: name, unit, range and meaning beside the field that holds its value. Readers
/// (ROS parameters, YAML files), the checks and the documentation tests all go by it.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace map_matcher::parameters {

/// A named option. It points at a field of an options struct, which must outlive it.
struct Parameter {
  std::string name;         ///< under_scored, as in config/*.yaml.
  std::string unit;         ///< "m", "rad", "s", "cells", "percent", "Hz" or "" when it has none.
  std::string description;  ///< One sentence: its effect.
  std::variant<bool*, int*, double*, std::string*, std::vector<std::string>*, std::map<std::string, std::string>*>
      value;
  double min = -std::numeric_limits<double>::infinity();  ///< Smallest allowed number, inclusive.
  double max = std::numeric_limits<double>::infinity();   ///< Largest allowed number, inclusive.
  std::vector<std::string> choices = {};                  ///< Allowed strings; empty: any.
};

using ParameterList = std::vector<Parameter>;

/// What is wrong with a parameter's present value: "name is VALUE, expected RANGE", or "" when nothing is.
std::string problemWith(const Parameter& parameter);

/// The present value as YAML writes it.
std::string valueText(const Parameter& parameter);

/// What is allowed, in words: "0 to 1", "trinary | scale | raw", "true | false", "a list of texts", "texts by
/// name".
std::string rangeText(const Parameter& parameter);

}  // namespace map_matcher::parameters
