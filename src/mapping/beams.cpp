#include "map_matcher/mapping/beams.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::mapping {
namespace {

constexpr double kRangeMaxMargin = 0.01;  // [m] drivers report "nothing there" as range_max

}  // namespace

BeamFan castBeams(const scan::PlanarScan& scan, const scan::LaserMount& mount, const BeamLimits& limits) {
  scan.validate();
  const double max_range = limits.max_range > 0.0 ? limits.max_range : scan.range_max - kRangeMaxMargin;
  const double max_urange = limits.max_urange > 0.0 ? std::min(limits.max_urange, max_range) : max_range;
  const double turn = mount.upside_down ? -1.0 : 1.0;
  BeamFan fan;
  fan.origin = mount.T_base_laser.translation();
  fan.beams.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double measured = static_cast<double>(scan.ranges[i]);
    const double range = measured < scan.range_min ? scan.range_max : measured;
    if (std::isnan(range) || range > max_range) {
      continue;
    }
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const double direction = mount.T_base_laser.yaw + turn * angle;
    const double length = std::min(range, max_urange);
    const Eigen::Vector2d end = fan.origin + length * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    fan.beams.push_back({end, range <= max_urange});
  }
  return fan;
}

BeamFan transform(const grid::Rigid2& T_a_b, const BeamFan& fan) {
  const Eigen::Matrix2d rotation = T_a_b.rotation();
  BeamFan moved{T_a_b * fan.origin, fan.beams};
  for (Beam& beam : moved.beams) {
    beam.end = rotation * beam.end + T_a_b.translation();
  }
  return moved;
}

int countHits(const BeamFan& fan) {
  return static_cast<int>(std::count_if(fan.beams.begin(), fan.beams.end(), [](const Beam& beam) { return beam.hit; }));
}

}  // namespace map_matcher::mapping
