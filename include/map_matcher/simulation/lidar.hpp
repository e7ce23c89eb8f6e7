/// \file
/// A planar lidar that looks at a world.
#pragma once

#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/scan/planar_scan.hpp"
#include "map_matcher/simulation/circle.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// The lidar of the report's section 3.3.1: 270 degrees, 20 m, noise N(0, sigma^2); beams and shortest range are those
/// of the SICK TiM571 on the CROWDBOT Pepper. Ranges stand in parametersOf().
struct LidarOptions {
  int beams = 811;                            ///< Rays of a scan, the first and last at the edges of the field of view.
  double field_of_view = 4.71238898038469;    ///< [rad] Angle between the first and the last ray.
  double range_min = 0.05;                    ///< [m] Nearer surfaces return nothing.
  double range_max = 20.0;                    ///< [m] Farther surfaces return nothing.
  double sigma = 0.03;                        ///< [m] Standard deviation of a measured range.
  grid::Rigid2 T_base_lidar{0.15, 0.0, 0.0};  ///< Mounting pose on the robot.
};

/// The parameters that fill `options`.
parameters::ParameterList parametersOf(LidarOptions& options);

/// A scan, and what was in it.
struct LidarView {
  scan::PlanarScan scan;
  std::vector<int> rays_on;  ///< For each circle: how many rays returned from it.
};

/// Measures ranges with noise of its own. Not thread-safe.
class Lidar {
 public:
  /// Throws std::invalid_argument that names every option out of its range.
  Lidar(const LidarOptions& options, const RandomNumbers& noise);

  /// The scan from a robot that stands at this pose; all rays at one instant.
  scan::PlanarScan scan(const World& world, const grid::Rigid2& T_map_base);

  /// The same among round obstacles, such as legs, in the map frame. They and the walls hide each other.
  LidarView scanAmong(const std::vector<Circle>& circles, const World& world, const grid::Rigid2& T_map_base);

 private:
  LidarOptions options_;
  RandomNumbers noise_;
};

}  // namespace map_matcher::simulation
