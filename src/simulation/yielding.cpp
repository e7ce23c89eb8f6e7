#include "map_matcher/simulation/yielding.hpp"

#include <algorithm>

namespace map_matcher::simulation {
namespace {

bool keepsOff(const std::vector<Eigen::Vector2d>& way, const Circle& person, const DifferentialDrive& robot) {
  const double now = (robot.T_map_base().translation() - person.centre).norm();
  const double allowed = std::min(now, robot.options().radius + person.radius + kDistanceToPeople);
  return std::all_of(way.begin(), way.end(),
                     [&](const Eigen::Vector2d& centre) { return (centre - person.centre).norm() >= allowed; });
}

}  // namespace

std::vector<Eigen::Vector2d> brakingWay(DifferentialDrive robot, double period) {
  std::vector<Eigen::Vector2d> way{robot.T_map_base().translation()};
  while (robot.velocity().linear > 0.0) {
    robot.drive({}, period);
    way.push_back(robot.T_map_base().translation());
  }
  return way;
}

Velocity yieldTo(const std::vector<Circle>& people, const DifferentialDrive& robot, const Velocity& wanted,
                 double period) {
  for (const double share : {1.0, 0.6, 0.3, 0.1}) {
    const Velocity tried{share * wanted.linear, share * wanted.angular};
    DifferentialDrive next = robot;
    next.drive(tried, period);
    const std::vector<Eigen::Vector2d> way = brakingWay(next, period);
    if (std::all_of(people.begin(), people.end(), [&](const Circle& person) { return keepsOff(way, person, robot); })) {
      return tried;
    }
  }
  return {};
}

}  // namespace map_matcher::simulation
