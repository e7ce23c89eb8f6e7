/// \file
/// One scan of what several lasers saw.
#pragma once

#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/scan/planar_scan.hpp"

namespace map_matcher::scan {

/// A scan of a laser that may move while it turns. Between its first and its last beam it moves evenly.
struct MovingScan {
  PlanarScan scan;
  grid::Rigid2 T_target_first;  ///< The laser at its first beam, in the frame of the merged scan, seen from above.
  grid::Rigid2 T_target_last;   ///< At its last beam.
  bool upside_down = false;     ///< Whether its z axis points down, so that its beams turn clockwise seen from above.
};

/// Beams of a merged scan: all round, the first one pointing backwards (-pi), evenly spaced.
struct MergedLayout {
  int num_beams = 1080;     ///< 8 to 100000.
  double range_min = 0.05;  ///< [m] What is nearer to the target's origin is left out; at least 0.
  double range_max = 20.0;  ///< [m] What is farther is left out; above range_min, up to 1e6.
};

/// The scan that a laser at the origin of the target frame would have made of all points that were measured: of those
/// in a beam the nearest one, inf where there is none. Ranges of the scans that are nan, inf, or outside their own
/// range_min and range_max show nothing. Throws std::invalid_argument for a scan or a layout that is not valid.
PlanarScan mergeScans(const std::vector<MovingScan>& scans, const MergedLayout& layout);

}  // namespace map_matcher::scan
