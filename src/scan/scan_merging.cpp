#include "map_matcher/scan/scan_merging.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace map_matcher::scan {
namespace {

constexpr double kPi = 3.14159265358979323846;

PlanarScan emptyScan(const MergedLayout& layout) {
  if (layout.num_beams < 8 || layout.num_beams > 100000) {
    throw std::invalid_argument("num_beams is " + std::to_string(layout.num_beams) + ", expected 8 to 100000");
  }
  PlanarScan merged;
  merged.angle_min = -kPi;
  merged.angle_increment = 2.0 * kPi / layout.num_beams;
  merged.range_min = layout.range_min;
  merged.range_max = layout.range_max;
  merged.ranges.assign(static_cast<std::size_t>(layout.num_beams), std::numeric_limits<float>::infinity());
  merged.validate();
  return merged;
}

/// The pose at a share of the way, 0 to 1.
grid::Rigid2 between(const grid::Rigid2& first, const grid::Rigid2& last, double share) {
  return {first.x + share * (last.x - first.x), first.y + share * (last.y - first.y),
          first.yaw + share * grid::normalizeAngle(last.yaw - first.yaw)};
}

/// The point of a beam in the target frame [m].
Eigen::Vector2d pointOf(const MovingScan& moving, std::size_t beam, double range) {
  const std::size_t num_beams = moving.scan.ranges.size();
  const double share = num_beams > 1 ? static_cast<double>(beam) / static_cast<double>(num_beams - 1) : 0.0;
  const double angle = moving.scan.angle_min + static_cast<double>(beam) * moving.scan.angle_increment;
  const double y = range * std::sin(angle);
  return between(moving.T_target_first, moving.T_target_last, share) *
         Eigen::Vector2d(range * std::cos(angle), moving.upside_down ? -y : y);
}

void add(const MovingScan& moving, PlanarScan& merged) {
  moving.scan.validate();
  for (std::size_t beam = 0; beam < moving.scan.ranges.size(); ++beam) {
    const auto range = static_cast<double>(moving.scan.ranges[beam]);
    if (!(range >= moving.scan.range_min && range <= moving.scan.range_max)) {
      continue;
    }
    const Eigen::Vector2d point = pointOf(moving, beam, range);
    const double distance = point.norm();
    if (!(distance >= merged.range_min && distance <= merged.range_max)) {
      continue;
    }
    const double bearing = std::atan2(point.y(), point.x()) - merged.angle_min;  // 0 to 2 pi
    const auto nearest = static_cast<std::size_t>(std::lround(bearing / merged.angle_increment));
    float& merged_range = merged.ranges[nearest % merged.ranges.size()];
    merged_range = std::min(merged_range, static_cast<float>(distance));
  }
}

}  // namespace

PlanarScan mergeScans(const std::vector<MovingScan>& scans, const MergedLayout& layout) {
  PlanarScan merged = emptyScan(layout);
  for (const MovingScan& scan : scans) {
    add(scan, merged);
  }
  return merged;
}

}  // namespace map_matcher::scan
