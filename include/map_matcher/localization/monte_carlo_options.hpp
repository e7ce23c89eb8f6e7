/// \file
/// What can be chosen about Monte-Carlo localization.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::localization {

/// Options of a MonteCarloLocalizer. Names, meanings and defaults are those of amcl (package amcl of the ROS navigation
/// stack) where it has such a parameter, but for the number of particles, which a start without a pose needs more of,
/// and the noise of the odometry, which is that of the simulated one. Ranges stand in parametersOf().
struct MonteCarloOptions {
  std::uint64_t seed = 1;                    ///< Of all random numbers.
  int min_particles = 100;                   ///< Particles of a filter that is certain.
  int max_particles = 50000;                 ///< Particles at the start; amcl: 5000, meant for a start with a pose.
  double kld_err = 0.01;                     ///< Largest error between the true distribution and the particles'.
  double kld_z = 0.99;                       ///< Standard normal quantile of the probability that kld_err holds.
  double update_min_d = 0.2;                 ///< [m] Motion after which the particles are weighed anew.
  double update_min_a = 0.5235987755982988;  ///< [rad] The same for turning.
  int laser_max_beams = 30;                  ///< Beams of each scan that are looked at, evenly spaced.
  double laser_z_hit = 0.95;                 ///< Weight of beams that end near walls.
  double laser_z_rand = 0.05;                ///< Weight of beams that end anywhere.
  double laser_max_range = 20.0;             ///< [m] Over which beams that end anywhere are spread.
  double laser_sigma_hit = 0.2;              ///< [m] Standard deviation of the distance to the wall.
  /// [m] Walls farther from the end of a beam are not looked for. amcl: 2, which with laser_sigma_hit 0.2 says the
  /// same.
  double laser_likelihood_max_dist = 1.0;
  /// Exponent of the likelihood of a scan, whose beams depend on each other. amcl has no such parameter; it adds up
  /// cubes of the beams' likelihoods instead of multiplying, which is as mild. On simulated drives without people the
  /// filter was sure of wrong places more often with 1, and took twice as long with 0.1; among people neither helped.
  double likelihood_power = 0.3;
  double odom_alpha1 = 0.01;     ///< [1] Variance of a turn [rad^2] per squared turn [rad^2]; amcl: 0.2, as the others.
  double odom_alpha2 = 0.001;    ///< [rad^2/m^2] Variance of a turn per squared distance.
  double odom_alpha3 = 0.003;    ///< [1] Variance of a distance [m^2] per squared distance [m^2].
  double odom_alpha4 = 0.0005;   ///< [m^2/rad^2] Variance of a distance per squared turn.
  double map_resolution = 0.05;  ///< [m] Maps with smaller cells are drawn with cells of this size.
};

/// The parameters that fill `options`, all but the seed.
parameters::ParameterList parametersOf(MonteCarloOptions& options);

/// What is wrong with the options, one line each; empty when they can be used.
std::vector<std::string> problemsWith(const MonteCarloOptions& options);

}  // namespace map_matcher::localization
