/// \file
/// Where a scan fits into what was drawn so far, given what odometry says.
#pragma once

#include "map_matcher/mapping/hit_counting_grid.hpp"
#include "map_matcher/mapping/odometry_noise.hpp"

namespace map_matcher::mapping {

/// What can be chosen about it.
struct ScanMatchOptions {
  double sigma = 0.05;       ///< [m] Deviation of a beam's end from the wall that it ended at, as that was drawn.
  double occ_thresh = 0.25;  ///< As in SessionMapperOptions.
};

/// Where a scan fits.
struct ScanMatch {
  PoseEstimate estimate;  ///< What odometry and the scan say together.
  int points = 0;         ///< Ends of beams, thinned out, that lie where the grid is known.
  double fit = 0.0;       ///< Share of these that lie at walls; 0 without points.
  double all_fit = 0.0;   ///< Share of all ends, those in unknown space included, that lie at walls.
  double misfit = 0.0;    ///< What the distances from the walls cost: so much less likely is the scan, as a logarithm.
};

/// The pose at which the odometry's prediction and the scan together are most likely: iteratively reweighted
/// Gauss-Newton steps, with the distances of the beams' ends from the straight pieces of wall nearest to them, and the
/// prediction as one more observation. Ends that are far from all walls (people who walk, what was not seen before)
/// count little, with weights of Geman and McClure that narrow down step by step. Directions in which the walls tell
/// nothing, as along a corridor, are left to the prediction. `fan` is in the base frame.
ScanMatch matchScan(const HitCountingGrid& grid, const BeamFan& fan, const PoseEstimate& predicted,
                    const ScanMatchOptions& options);

}  // namespace map_matcher::mapping
