#include "map_matcher/scan/planar_scan.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace map_matcher {

void ScanLayout::validate() const {
  if (!std::isfinite(angle_min)) {
    throw std::invalid_argument("angle_min is " + std::to_string(angle_min) + ", expected a finite angle in rad");
  }
  if (!std::isfinite(angle_increment) || angle_increment == 0.0) {
    throw std::invalid_argument("angle_increment is " + std::to_string(angle_increment) +
                                ", expected a finite angle in rad other than 0");
  }
  if (!std::isfinite(range_min) || range_min < 0.0) {
    throw std::invalid_argument("range_min is " + std::to_string(range_min) + ", expected at least 0 m");
  }
  if (!std::isfinite(range_max) || range_max <= range_min) {
    throw std::invalid_argument("range_max is " + std::to_string(range_max) +
                                ", expected more than range_min = " + std::to_string(range_min) + " m");
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

}  // namespace map_matcher
