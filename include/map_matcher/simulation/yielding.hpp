/// \file
/// A robot that gives way to people.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "map_matcher/simulation/circle.hpp"
#include "map_matcher/simulation/robot.hpp"

namespace map_matcher::simulation {

/// Centres [m] of a robot that brakes from now on as hard as it can, in steps of `period` [s]: first where it is, last
/// where it stops.
std::vector<Eigen::Vector2d> brakingWay(DifferentialDrive robot, double period);

constexpr double kDistanceToPeople = 0.12;  ///< [m] from a robot to people whom it approaches.

/// The wanted velocity, or as much of it as leaves the robot kDistanceToPeople from everybody when it brakes one
/// `period` [s] later; where it is nearer already, no nearer. When nothing does, it brakes. As long as nobody steps
/// into its brakingWay(), a robot that goes by this touches nobody. `people`: in the map frame.
Velocity yieldTo(const std::vector<Circle>& people, const DifferentialDrive& robot, const Velocity& wanted,
                 double period);

}  // namespace map_matcher::simulation
