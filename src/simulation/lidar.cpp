#include "map_matcher/simulation/lidar.hpp"

#include <cmath>
#include <limits>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/simulation/round_obstacles.hpp"

namespace map_matcher::simulation {

parameters::ParameterList parametersOf(LidarOptions& options) {
  return {
      {"beams", "", "Rays of a scan, the first and last at the edges of the field of view.", &options.beams, 2, 100000},
      {"field_of_view", "rad", "Angle between the first and the last ray.", &options.field_of_view, 0.01, 6.2832},
      {"range_min", "m", "Nearer surfaces return nothing.", &options.range_min, 0.0, 1.0},
      {"range_max", "m", "Farther surfaces return nothing.", &options.range_max, 1.0, 1000.0},
      {"sigma", "m", "Standard deviation of a measured range.", &options.sigma, 0.0, 1.0},
      {"lidar_x", "m", "Forward offset of the lidar on the robot.", &options.T_base_lidar.x, -2.0, 2.0},
      {"lidar_y", "m", "Offset of the lidar to the left on the robot.", &options.T_base_lidar.y, -2.0, 2.0},
      {"lidar_yaw", "rad", "Heading of the lidar on the robot.", &options.T_base_lidar.yaw, -3.1416, 3.1416},
  };
}

Lidar::Lidar(const LidarOptions& options, const RandomNumbers& noise) : options_(options), noise_(noise) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options_)));
}

scan::PlanarScan Lidar::scan(const World& world, const grid::Rigid2& T_map_base) {
  return scanAmong({}, world, T_map_base).scan;
}

LidarView Lidar::scanAmong(const std::vector<Circle>& circles, const World& world, const grid::Rigid2& T_map_base) {
  const double angle_min = -0.5 * options_.field_of_view;
  const double angle_increment = options_.field_of_view / (options_.beams - 1);
  const grid::Rigid2 T_map_lidar = T_map_base * options_.T_base_lidar;
  // Noise may bring a surface beyond the range back into it: rays look a little farther.
  const double reach = options_.range_max + 6.0 * options_.sigma;
  std::vector<double> walls;
  walls.reserve(static_cast<std::size_t>(options_.beams));
  for (int i = 0; i < options_.beams; ++i) {
    walls.push_back(world.castRay(T_map_lidar.translation(), T_map_lidar.yaw + angle_min + i * angle_increment, reach));
  }
  const RaysOnCircles nearest = castOnCircles(circles, T_map_lidar, {angle_min, angle_increment, reach}, walls);

  LidarView view;
  view.scan = {{angle_min, angle_increment, options_.range_min, options_.range_max}, {}};
  view.scan.ranges.reserve(walls.size());
  view.rays_on.assign(circles.size(), 0);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    // Drawn for every ray, so that one ray's return does not change the noise of the others.
    const double range = nearest.distances[i] + options_.sigma * noise_.gaussian();
    const bool returned = range >= options_.range_min && range <= options_.range_max;
    view.scan.ranges.push_back(returned ? static_cast<float>(range) : std::numeric_limits<float>::infinity());
    if (returned && nearest.circles[i]) {
      ++view.rays_on[*nearest.circles[i]];
    }
  }
  return view;
}

}  // namespace map_matcher::simulation
