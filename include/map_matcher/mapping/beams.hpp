/// \file
/// What the beams of a scan say about the space around the robot.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "map_matcher/scan/planar_scan.hpp"

namespace map_matcher::mapping {

/// How far beams are believed; slam_gmapping's parameters of the same names.
struct BeamLimits {
  double max_range = 0.0;   ///< Longer beams say nothing [m]; 0: the scan's range_max less 1 cm.
  double max_urange = 0.0;  ///< Longer beams clear the space up to here and show no wall [m]; 0: as max_range.
};

/// A beam that says something.
struct Beam {
  Eigen::Vector2d end{0.0, 0.0};  ///< Where it ends [m]; the space from the laser up to here is free.
  bool hit = false;               ///< Whether it ends at a wall.
};

/// Beams that leave the laser at one point; all in the same frame.
struct BeamFan {
  Eigen::Vector2d origin{0.0, 0.0};  ///< The laser [m].
  std::vector<Beam> beams;           ///< In the order of the ranges.
};

/// The beams of a scan in the base frame, read as slam_gmapping reads them: nan and +inf say nothing; a range below
/// range_min (0 and -inf too) counts as range_max; a range above max_range says nothing, one above max_urange clears.
/// The number of ranges may change from scan to scan. Throws std::invalid_argument for a scan that is not valid.
BeamFan castBeams(const scan::PlanarScan& scan, const scan::LaserMount& mount, const BeamLimits& limits);

/// The fan in frame a, given the fan in frame b.
BeamFan transform(const grid::Rigid2& T_a_b, const BeamFan& fan);

/// Number of beams that end at a wall.
int countHits(const BeamFan& fan);

}  // namespace map_matcher::mapping
