#include "map_matcher/parameters/number_text.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace map_matcher::parameters {
namespace {

constexpr double kLargestPlain = 1e15;  // from here on the exponent is shorter

std::string textOf(double value, int precision) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(precision);
  out << value;
  return out.str();
}

double numberOf(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = std::numeric_limits<double>::quiet_NaN();
  in >> value;
  return value;
}

}  // namespace

std::string numberText(double value) {
  if (std::isfinite(value) && value == std::trunc(value) && std::abs(value) < kLargestPlain) {
    return std::to_string(static_cast<long long>(value));
  }
  int precision = 1;
  std::string text = textOf(value, precision);
  while (std::isfinite(value) && numberOf(text) != value && precision < std::numeric_limits<double>::max_digits10) {
    text = textOf(value, ++precision);
  }
  return text;
}

}  // namespace map_matcher::parameters
