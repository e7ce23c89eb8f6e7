/// \file
/// What a misspelt name was meant to be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::parameters {

/// The known name that `name` was most likely meant to be; none when all differ by more than a third of their letters.
std::optional<std::string> nearestName(const std::string& name, const std::vector<std::string>& known);

/// The same among the names of parameters.
std::optional<std::string> nearestName(const std::string& name, const ParameterList& parameters);

}  // namespace map_matcher::parameters
