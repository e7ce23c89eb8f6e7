/// \file
/// Numbers as people write them.
#pragma once

#include <string>

namespace map_matcher::parameters {

/// The shortest decimal text that reads back as the same number: 0.05 is "0.05", a million is "1000000"; "nan" and
/// "inf" for what is not a number. Locale-independent.
std::string numberText(double value);

}  // namespace map_matcher::parameters
