#include "map_matcher/localization/monte_carlo_options.hpp"

#include <sstream>

#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::localization {

parameters::ParameterList parametersOf(MonteCarloOptions& options) {
  return {
      {"min_particles", "", "Particles of a filter that is certain.", &options.min_particles, 1, 1000000},
      {"max_particles", "", "Particles at the start, and at most.", &options.max_particles, 1, 1000000},
      {"kld_err", "", "Largest error between the true distribution and that of the particles.", &options.kld_err, 1e-4,
       1.0},
      {"kld_z", "", "Standard normal quantile of the probability that kld_err holds.", &options.kld_z, 0.0, 5.0},
      {"update_min_d", "m", "Motion after which the particles are weighed anew.", &options.update_min_d, 0.0, 10.0},
      {"update_min_a", "rad", "Turning after which the particles are weighed anew.", &options.update_min_a, 0.0, 6.3},
      {"laser_max_beams", "", "Beams of each scan that are looked at, evenly spaced.", &options.laser_max_beams, 2,
       10000},
      {"laser_z_hit", "", "Weight of beams that end near walls.", &options.laser_z_hit, 0.0, 1.0},
      {"laser_z_rand", "", "Weight of beams that end anywhere.", &options.laser_z_rand, 1e-4, 1.0},
      {"laser_max_range", "m", "Over which beams that end anywhere are spread.", &options.laser_max_range, 1.0, 1000.0},
      {"laser_sigma_hit", "m", "Standard deviation of the distance from the end of a beam to the wall.",
       &options.laser_sigma_hit, 0.01, 5.0},
      {"laser_likelihood_max_dist", "m", "Walls farther from the end of a beam are not looked for.",
       &options.laser_likelihood_max_dist, 0.05, 10.0},
      {"likelihood_power", "", "Exponent of the likelihood of a scan.", &options.likelihood_power, 0.01, 1.0},
      {"odom_alpha1", "", "Variance of a turn per squared turn.", &options.odom_alpha1, 0.0, 1.0},
      {"odom_alpha2", "rad^2/m^2", "Variance of a turn per squared distance.", &options.odom_alpha2, 0.0, 1.0},
      {"odom_alpha3", "", "Variance of a distance per squared distance.", &options.odom_alpha3, 0.0, 1.0},
      {"odom_alpha4", "m^2/rad^2", "Variance of a distance per squared turn.", &options.odom_alpha4, 0.0, 1.0},
      {"map_resolution", "m", "Maps with smaller cells are drawn with cells of this size.", &options.map_resolution,
       0.01, 1.0},
  };
}

std::vector<std::string> problemsWith(const MonteCarloOptions& options) {
  MonteCarloOptions copy = options;
  std::vector<std::string> problems = parameters::problemsOf(parametersOf(copy));
  if (options.min_particles > options.max_particles) {
    std::ostringstream text;
    text << "min_particles is " << options.min_particles
         << ", expected at most max_particles = " << options.max_particles;
    problems.push_back(text.str());
  }
  return problems;
}

}  // namespace map_matcher::localization
