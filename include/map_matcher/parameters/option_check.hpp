/// \file
/// One way to refuse options: all that is wrong, at once.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::parameters {

/// One sentence for each parameter out of its range: "name is VALUE, expected RANGE".
std::vector<std::string> problemsOf(const ParameterList& parameters);

/// Throws std::invalid_argument with all problems, joined by "; ", when there are any.
void throwIfAny(const std::vector<std::string>& problems);

}  // namespace map_matcher::parameters
