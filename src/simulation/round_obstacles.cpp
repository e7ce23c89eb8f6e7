#include "map_matcher/simulation/round_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "map_matcher/scan/beams_near.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A circle as the lidar sees it.
struct SeenCircle {
  double distance;  // [m] of its centre
  double bearing;   // [rad] of its centre
  double radius;    // [m]
};

/// Distance [m] along a ray at this angle [rad] to where it enters the circle; infinity when it does not.
double entryInto(const SeenCircle& circle, double angle) {
  if (circle.distance <= circle.radius) {
    return 0.0;
  }
  const double along = circle.distance * std::cos(angle - circle.bearing);
  const double across = circle.distance * std::sin(angle - circle.bearing);
  const double half_chord_squared = circle.radius * circle.radius - across * across;
  return along > 0.0 && half_chord_squared >= 0.0 ? along - std::sqrt(half_chord_squared) : kInfinity;
}

}  // namespace

RaysOnCircles castOnCircles(const std::vector<Circle>& circles, const grid::Rigid2& T_map_lidar, const RayFan& fan,
                            const std::vector<double>& background) {
  RaysOnCircles nearest{background, std::vector<std::optional<std::size_t>>(background.size())};
  const grid::Rigid2 T_lidar_map = T_map_lidar.inverse();
  const Eigen::Matrix2d rotation = T_lidar_map.rotation();
  for (std::size_t k = 0; k < circles.size(); ++k) {
    const Eigen::Vector2d centre = rotation * circles[k].centre + T_lidar_map.translation();
    const double distance = centre.norm();
    if (!(distance - circles[k].radius <= fan.range_max)) {
      continue;
    }
    const SeenCircle seen{distance, std::atan2(centre.y(), centre.x()), circles[k].radius};
    const double half_width = seen.distance > seen.radius ? std::asin(seen.radius / seen.distance) : M_PI;
    scan::visitBeamsNear(fan.angle_min, fan.angle_increment, background.size(), seen.bearing, half_width, 0.0,
                         [&](const scan::BeamRange& rays) {
                           for (std::size_t i = rays.begin; i < rays.end; ++i) {
                             const double entry =
                                 entryInto(seen, fan.angle_min + static_cast<double>(i) * fan.angle_increment);
                             if (entry < nearest.distances[i]) {
                               nearest.distances[i] = entry;
                               nearest.circles[i] = k;
                             }
                           }
                         });
  }
  return nearest;
}

LidarView insertCircles(const scan::PlanarScan& scan, const std::vector<Circle>& circles,
                        const grid::Rigid2& T_map_lidar, double sigma, RandomNumbers& noise) {
  std::vector<double> background(scan.ranges.size(), kInfinity);
  for (std::size_t i = 0; i < background.size(); ++i) {
    const double range = scan.ranges[i];
    if (std::isfinite(range) && range >= scan.range_min && range <= scan.range_max) {
      background[i] = range;
    }
  }
  const RaysOnCircles nearest =
      castOnCircles(circles, T_map_lidar, {scan.angle_min, scan.angle_increment, scan.range_max}, background);
  LidarView among{scan, std::vector<int>(circles.size(), 0)};
  for (std::size_t i = 0; i < background.size(); ++i) {
    if (nearest.circles[i]) {
      const double range = nearest.distances[i] + sigma * noise.gaussian();
      const bool returned = range >= scan.range_min && range <= scan.range_max;
      among.scan.ranges[i] = returned ? static_cast<float>(range) : std::numeric_limits<float>::infinity();
      among.rays_on[*nearest.circles[i]] += returned ? 1 : 0;
    }
  }
  return among;
}

}  // namespace map_matcher::simulation
