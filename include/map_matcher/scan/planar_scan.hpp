/// \file
/// One revolution of a planar laser and how the laser sits on the robot.
#pragma once

#include <vector>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::scan {

/// Where the beams of a scan point and how far they reach, as sensor_msgs/LaserScan has it. Beam i points along
/// angle_min + i * angle_increment in the laser frame, counter-clockwise about the laser's z axis.
struct ScanLayout {
  double angle_min = 0.0;        ///< Direction of the first beam [rad], -1000 to 1000.
  double angle_increment = 0.0;  ///< Between beams [rad], 1e-6 to a turn; negative for a laser that turns clockwise.
  double range_min = 0.0;        ///< Shortest range the laser measures [m], at least 0.
  double range_max = 0.0;        ///< Longest range the laser measures [m], above range_min, up to 1e6.

  /// Throws std::invalid_argument, with the name and value of the offending field, unless all are in their ranges.
  void validate() const;
};

bool operator==(const ScanLayout& a, const ScanLayout& b);
inline bool operator!=(const ScanLayout& a, const ScanLayout& b) { return !(a == b); }

/// Ranges of a planar laser.
struct PlanarScan : ScanLayout {
  std::vector<float> ranges;  ///< [m]; inf, nan and values outside [range_min, range_max] are allowed (castBeams).

  /// Throws std::invalid_argument as ScanLayout::validate(), and when there is no range.
  void validate() const;
};

/// How a laser sits on the robot. It scans in a plane parallel to the floor.
struct LaserMount {
  grid::Rigid2 T_base_laser;  ///< Pose of the laser in the base frame, seen from above.
  bool upside_down = false;   ///< Whether its z axis points down, so that its beams turn clockwise seen from above.
};

/// A scan of one of a robot's lasers.
struct MountedScan {
  PlanarScan scan;
  LaserMount mount;
};

}  // namespace map_matcher::scan
