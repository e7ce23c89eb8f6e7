#include "map_matcher/scan/planar_scan.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace map_matcher::scan {
namespace {

constexpr double kMaxAngle = 1000.0;    // [rad] many turns; farther from 0 sines say nothing
constexpr double kMinIncrement = 1e-6;  // [rad] no laser has millions of beams a turn
constexpr double kMaxRange = 1e6;       // [m] so that range_max + 1 m is still another number in 32 bits

/// "angle_min is 1e+30, expected a finite angle in rad"
std::string unexpected(const char* name, double value, const std::string& expected) {
  std::ostringstream text;
  text << name << " is " << value << ", expected " << expected;
  return text.str();
}

}  // namespace

void ScanLayout::validate() const {
  if (!(std::abs(angle_min) <= kMaxAngle)) {
    throw std::invalid_argument(unexpected("angle_min", angle_min, "-1000 to 1000 rad"));
  }
  if (!(std::abs(angle_increment) >= kMinIncrement && std::abs(angle_increment) <= 2.0 * M_PI)) {
    throw std::invalid_argument(
        unexpected("angle_increment", angle_increment, "1e-6 rad to a turn, in either direction"));
  }
  if (!(range_min >= 0.0 && range_min <= kMaxRange)) {
    throw std::invalid_argument(unexpected("range_min", range_min, "0 to 1e6 m"));
  }
  if (!(range_max > range_min && range_max <= kMaxRange)) {
    throw std::invalid_argument(
        unexpected("range_max", range_max, "more than range_min = " + std::to_string(range_min) + " and up to 1e6 m"));
  }
}

bool operator==(const ScanLayout& a, const ScanLayout& b) {
  return a.angle_min == b.angle_min && a.angle_increment == b.angle_increment && a.range_min == b.range_min &&
         a.range_max == b.range_max;
}

void PlanarScan::validate() const {
  ScanLayout::validate();
  if (ranges.empty()) {
    throw std::invalid_argument("the scan has 0 ranges, expected at least 1");
  }
}

}  // namespace map_matcher::scan
