/// \file
/// The beams of a scan that point into a direction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace map_matcher::scan {

/// A range of beams: from `begin` up to, but without, `end`.
struct BeamRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Calls `visit(BeamRange)` for the beams of a scan that point within `half_width` + `margin` beams of a direction;
/// more than once for a scan of more than a turn. Beam i points along angle_min + i * angle_increment. Visits no beam
/// twice, and takes no longer than a look at every beam, whatever the angles are; what it visits makes sense for a
/// valid ScanLayout. `bearing` [rad] lies within a turn of 0, `half_width` [rad] and `margin` [beams], which is for
/// rounding, are at least 0.
template <typename Visit>
void visitBeamsNear(double angle_min, double angle_increment, std::size_t num_beams, double bearing, double half_width,
                    double margin, Visit&& visit) {
  const auto count = static_cast<double>(num_beams);
  const double turn = 2.0 * M_PI / std::abs(angle_increment);            // [beams]
  const double width = half_width / std::abs(angle_increment) + margin;  // [beams]
  // Windows that leave nothing out are not gone through one by one: there may be billions of them, or they may be so
  // near to each other that the next one is the same number. The negation holds for nan.
  if (!(2.0 * width + 1.0 < turn)) {
    visit(BeamRange{0, num_beams});
    return;
  }
  double middle = std::fmod((bearing - angle_min) / angle_increment, turn);  // [beams]
  if (middle + width < 0.0) {
    middle += turn;
  } else if (middle + width >= turn) {
    middle -= turn;  // the first window that may reach beam 0
  }
  for (; middle - width < count; middle += turn) {
    const double begin = std::clamp(std::ceil(middle - width), 0.0, count);
    const double end = std::clamp(std::floor(middle + width) + 1.0, begin, count);
    visit(BeamRange{static_cast<std::size_t>(begin), static_cast<std::size_t>(end)});
  }
}

}  // namespace map_matcher::scan
