/// \file
/// Arguments as they are written and read. Private to command_line.cpp.
#pragma once

#include <string>
#include <vector>

#include "command_line.hpp"

namespace map_matcher::tools {

/// Whether an option with this target takes any number of values.
bool isList(const OptionTarget& target);

/// What the help writes in the place of a value: NUMBER, TEXT, ...
std::string kindOf(const OptionTarget& target);

/// What is expected of each value, in words.
std::string expectedFor(const OptionTarget& target);

/// The present value; "" when there is none.
std::string textOf(const OptionTarget& target);

/// Whether the target can take all of the values; there is at least one.
bool isReadable(const std::vector<std::string>& values, const OptionTarget& target);

/// Sets the target to values that are readable. A list is `replaced` or gets longer.
void read(const std::vector<std::string>& values, const OptionTarget& target, bool replaced);

/// The texts in a row.
std::string joined(const std::vector<std::string>& texts, const std::string& separator = " ");

}  // namespace map_matcher::tools
