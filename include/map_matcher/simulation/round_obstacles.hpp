/// \file
/// How legs come into a scan.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/simulation/circle.hpp"
#include "map_matcher/simulation/lidar.hpp"
#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {

/// Rays from the origin of a lidar's frame: ray i points at angle_min + i * angle_increment.
struct RayFan {
  double angle_min = 0.0;        ///< [rad]
  double angle_increment = 0.0;  ///< [rad] Not 0; negative for a lidar that is mounted upside down.
  double range_max = 0.0;        ///< [m] Circles farther away are not looked at.
};

/// What rays meet first.
struct RaysOnCircles {
  std::vector<double> distances;                    ///< [m] To the nearest of circle and background, for each ray.
  std::vector<std::optional<std::size_t>> circles;  ///< Index of the circle that a ray meets; none: the background.
};

/// Where rays that meet a background at these distances [m] (infinity: none) meet circles before it. A lidar within a
/// circle sees its inside, at 0 m. `circles` are in the map frame. Looks only at the rays that a circle spans.
RaysOnCircles castOnCircles(const std::vector<Circle>& circles, const grid::Rigid2& T_map_lidar, const RayFan& fan,
                            const std::vector<double>& background);

/// A recorded scan as it would have been among these circles (of the frame that T_map_lidar leads to): what lies behind
/// a circle is hidden by it, and rays that returned nothing (not finite, or out of range) return from a circle within
/// range. `sigma` [m] is the standard deviation of ranges to circles; other ranges stay bit for bit. `noise` is drawn
/// from once for each such range. A lidar that hangs upside down is one whose angles run backwards.
LidarView insertCircles(const scan::PlanarScan& scan, const std::vector<Circle>& circles,
                        const grid::Rigid2& T_map_lidar, double sigma, RandomNumbers& noise);

}  // namespace map_matcher::simulation
