/// \file
/// A differential-drive robot and its wheel odometry.
#pragma once

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {

/// What the robot's body and drive can do; the defaults are close to a Pioneer P3-DX at indoor speed (report 3.3.1).
/// Ranges stand in parametersOf().
struct RobotOptions {
  double radius = 0.25;                ///< [m] Circle around the base that holds the whole robot.
  double max_speed = 0.6;              ///< [m/s] Forward.
  double max_turn_rate = 1.0;          ///< [rad/s] Either way.
  double max_acceleration = 0.8;       ///< [m/s^2] Speeding up and braking.
  double max_turn_acceleration = 2.5;  ///< [rad/s^2]
};

/// The parameters that fill `options`.
parameters::ParameterList parametersOf(RobotOptions& options);

/// Velocity of a differential drive.
struct Velocity {
  double linear = 0.0;   ///< Forward [m/s].
  double angular = 0.0;  ///< Counter-clockwise [rad/s].
};

/// A robot that moves without slip along arcs and changes its velocity only as fast as its drive can.
class DifferentialDrive {
 public:
  /// Stands still at `T_map_base`. Throws std::invalid_argument that names every option out of its range.
  DifferentialDrive(const RobotOptions& options, const grid::Rigid2& T_map_base);

  /// Comes as close to the commanded velocity as the limits allow and keeps it for `duration` [s], which is positive.
  void drive(const Velocity& commanded, double duration);

  const RobotOptions& options() const { return options_; }
  const grid::Rigid2& T_map_base() const { return T_map_base_; }
  const Velocity& velocity() const { return velocity_; }

 private:
  RobotOptions options_;
  grid::Rigid2 T_map_base_;
  Velocity velocity_;
};

/// Noise of the odometry motion model (Thrun, Burgard, Fox: "Probabilistic Robotics", 2005, section 5.4, table 5.6): a
/// motion is a turn, a straight line and a turn, each measured with normally distributed noise. The noise is drawn once
/// a reading, so at n times the rate the error after a distance is sqrt(n) times smaller; the defaults suit 10 to 20
/// Hz: about 0.6 degrees and 1 % of the distance after a metre, 2 degrees after a full turn. Ranges stand in
/// parametersOf().
struct OdometryOptions {
  double alpha1 = 0.01;    ///< [1] Variance of a turn [rad^2] per squared turn [rad^2].
  double alpha2 = 0.001;   ///< [rad^2/m^2] Variance of a turn per squared distance.
  double alpha3 = 0.003;   ///< [1] Variance of a distance [m^2] per squared distance [m^2].
  double alpha4 = 0.0005;  ///< [m^2/rad^2] Variance of a distance per squared turn.
};

/// The parameters that fill `options`.
parameters::ParameterList parametersOf(OdometryOptions& options);

/// Adds up noisy readings of a robot's motion. The odom frame is where the robot stood at first.
class Odometry {
 public:
  /// Throws std::invalid_argument that names every option out of its range.
  Odometry(const OdometryOptions& options, const grid::Rigid2& T_map_base, const RandomNumbers& noise);

  /// Reads the motion from the last pose to this one, which is at most half a turn away.
  void read(const grid::Rigid2& T_map_base);

  /// Where the odometry believes the robot to be.
  const grid::Rigid2& T_odom_base() const { return T_odom_base_; }

 private:
  double noisy(double value, double variance);

  OdometryOptions options_;
  RandomNumbers noise_;
  grid::Rigid2 T_map_last_;
  grid::Rigid2 T_odom_base_;
};

}  // namespace map_matcher::simulation
