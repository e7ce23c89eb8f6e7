#include "map_matcher/simulation/robot.hpp"

#include <algorithm>
#include <cmath>

#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kStraight = 1e-9;  // [rad] arcs that turn less are driven as straight lines

/// The value nearest to `wanted` that lies within `largest_change` of `present` and within [low, high].
double approach(double present, double wanted, double largest_change, double low, double high) {
  return std::clamp(std::clamp(wanted, low, high), present - largest_change, present + largest_change);
}

/// Motion along an arc of this length [m] and turn [rad], in the frame of its start.
grid::Rigid2 arc(double length, double turn) {
  if (std::abs(turn) < kStraight) {
    return {length, 0.0, turn};
  }
  const double radius = length / turn;
  return {radius * std::sin(turn), radius * (1.0 - std::cos(turn)), turn};
}

}  // namespace

parameters::ParameterList parametersOf(RobotOptions& options) {
  return {
      {"radius", "m", "Circle around the base that holds the whole robot.", &options.radius, 0.01, 2.0},
      {"max_speed", "m/s", "Forward speed.", &options.max_speed, 0.05, 5.0},
      {"max_turn_rate", "rad/s", "Turn rate, either way.", &options.max_turn_rate, 0.05, 10.0},
      {"max_acceleration", "m/s^2", "Speeding up and braking.", &options.max_acceleration, 0.05, 10.0},
      {"max_turn_acceleration", "rad/s^2", "Change of the turn rate.", &options.max_turn_acceleration, 0.05, 100.0},
  };
}

DifferentialDrive::DifferentialDrive(const RobotOptions& options, const grid::Rigid2& T_map_base)
    : options_(options), T_map_base_(T_map_base) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options_)));
}

void DifferentialDrive::drive(const Velocity& commanded, double duration) {
  velocity_.linear =
      approach(velocity_.linear, commanded.linear, options_.max_acceleration * duration, 0.0, options_.max_speed);
  velocity_.angular = approach(velocity_.angular, commanded.angular, options_.max_turn_acceleration * duration,
                               -options_.max_turn_rate, options_.max_turn_rate);
  T_map_base_ = T_map_base_ * arc(velocity_.linear * duration, velocity_.angular * duration);
}

parameters::ParameterList parametersOf(OdometryOptions& options) {
  return {
      {"alpha1", "", "Variance of a turn per squared turn.", &options.alpha1, 0.0, 1.0},
      {"alpha2", "rad^2/m^2", "Variance of a turn per squared distance.", &options.alpha2, 0.0, 1.0},
      {"alpha3", "", "Variance of a distance per squared distance.", &options.alpha3, 0.0, 1.0},
      {"alpha4", "m^2/rad^2", "Variance of a distance per squared turn.", &options.alpha4, 0.0, 1.0},
  };
}

Odometry::Odometry(const OdometryOptions& options, const grid::Rigid2& T_map_base, const RandomNumbers& noise)
    : options_(options), noise_(noise), T_map_last_(T_map_base) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options_)));
}

void Odometry::read(const grid::Rigid2& T_map_base) {
  constexpr double kStandstill = 1e-9;  // [m] shorter ways have no direction
  const grid::Rigid2 motion = T_map_last_.inverse() * T_map_base;
  T_map_last_ = T_map_base;

  // Table 5.6 of Probabilistic Robotics, lines 2 to 7.
  const double distance = motion.translation().norm();
  const double turn1 = distance < kStandstill ? 0.0 : std::atan2(motion.y, motion.x);
  const double turn2 = grid::normalizeAngle(motion.yaw - turn1);
  const double squared_distance = distance * distance;
  const double squared_turn1 = turn1 * turn1;
  const double squared_turn2 = turn2 * turn2;
  const double read_turn1 = noisy(turn1, options_.alpha1 * squared_turn1 + options_.alpha2 * squared_distance);
  const double read_distance =
      noisy(distance, options_.alpha3 * squared_distance + options_.alpha4 * (squared_turn1 + squared_turn2));
  const double read_turn2 = noisy(turn2, options_.alpha1 * squared_turn2 + options_.alpha2 * squared_distance);

  T_odom_base_ = T_odom_base_ * grid::Rigid2{read_distance * std::cos(read_turn1), read_distance * std::sin(read_turn1),
                                             grid::normalizeAngle(read_turn1 + read_turn2)};
}

double Odometry::noisy(double value, double variance) { return value + std::sqrt(variance) * noise_.gaussian(); }

}  // namespace map_matcher::simulation
