#include "map_matcher/simulation/exploration.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::simulation {
namespace {

constexpr double kSight = 8.0;     // [m] up to which a cell counts as seen
constexpr double kNearest = 0.6;   // [m] from the robot to the next frontier, where there is one
constexpr double kAvoided = 2.0;   // [m] around a place that could not be reached
constexpr int kNeighbourhood = 2;  // [cells] around a frontier
constexpr int kFewestUnseen = 6;   // cells of the neighbourhood

}  // namespace

Exploration::Exploration(const PathPlanner& planner)
    : planner_(planner),
      seen_(static_cast<std::size_t>(planner.geometry().width) * static_cast<std::size_t>(planner.geometry().height)) {}

void Exploration::see(const scan::PlanarScan& scan, const grid::Rigid2& T_map_lidar) {
  const grid::GridGeometry& geometry = planner_.geometry();
  const grid::Rigid2 T_grid_lidar = geometry.T_map_grid.inverse() * T_map_lidar;
  const Eigen::Vector2d origin = T_grid_lidar.translation() / geometry.resolution;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double heading = T_grid_lidar.yaw + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    const double length = std::min<double>(scan.ranges[i], std::min(kSight, scan.range_max)) / geometry.resolution;
    for (double travelled = 0.0; travelled < length; travelled += 0.7) {
      const Eigen::Vector2d p = origin + travelled * direction;
      const grid::Cell cell{static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
      if (geometry.contains(cell)) {
        seen_[indexOf(cell)] = true;
      }
    }
  }
}

bool Exploration::isFrontier(const Eigen::Vector2d& place) const {
  const grid::Cell centre = planner_.geometry().cellAt(place);
  if (!planner_.isFree(centre) || !seen_[indexOf(centre)]) {
    return false;
  }
  int num_unseen = 0;
  for (int y = centre.y - kNeighbourhood; y <= centre.y + kNeighbourhood; ++y) {
    for (int x = centre.x - kNeighbourhood; x <= centre.x + kNeighbourhood; ++x) {
      num_unseen += planner_.isFree({x, y}) && !seen_[indexOf({x, y})] ? 1 : 0;
    }
  }
  return num_unseen >= kFewestUnseen;
}

std::optional<Path> Exploration::nextWay(const Eigen::Vector2d& position,
                                         const std::optional<Eigen::Vector2d>& avoided) const {
  return planner_.planToNearest(position, [&](const Eigen::Vector2d& place) {
    return (place - position).norm() >= kNearest && !(avoided && (place - *avoided).norm() < kAvoided) &&
           isFrontier(place);
  });
}

}  // namespace map_matcher::simulation
