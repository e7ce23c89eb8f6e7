/// \file
/// Monte-Carlo localization without an initial pose. Only for comparison: nothing else of this package uses it.
#pragma once

#include <memory>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/localization/monte_carlo_options.hpp"
#include "map_matcher/scan/planar_scan.hpp"

namespace map_matcher::localization {

/// Where the particles are.
struct MonteCarloEstimate {
  grid::Rigid2 T_map_base;          ///< Their mean, moved on by the odometry since they were last weighed.
  double position_deviation = 0.0;  ///< [m] Root of the sum of their variances along x and y.
  double yaw_deviation = 0.0;       ///< [rad] Standard deviation of their yaw.
  int particles = 0;                ///< How many there are.
};

/// Tracks where a robot may be in a map by MRPT's particle filter: mrpt::slam::CMonteCarloLocalization2D, with the
/// likelihood field of Thrun, Burgard, Fox ("Probabilistic Robotics", 2005, section 6.4) and as many particles as KLD
/// sampling asks for (Fox, "Adapting the sample size in particle filters through KLD-sampling", 2003). It starts with
/// particles everywhere in free space. The same seed gives the same estimates. Neither copied nor moved; not
/// thread-safe, not even two of them, since MRPT's random numbers are global.
class MonteCarloLocalizer {
 public:
  /// Whether this build has it: MRPT was there.
  static bool available();

  /// Throws std::invalid_argument that names every option out of range, or says that the map has no free cell, and
  /// std::runtime_error where it is not available.
  explicit MonteCarloLocalizer(const grid::OccupancyGrid& map, const MonteCarloOptions& options = {});
  ~MonteCarloLocalizer();
  MonteCarloLocalizer(const MonteCarloLocalizer&) = delete;
  MonteCarloLocalizer& operator=(const MonteCarloLocalizer&) = delete;

  /// Forgets where the robot may be: particles everywhere, with random numbers that were not used before.
  void reset();

  /// Takes the pose of the base in the odometry frame and the scans of all lasers at that time. Returns whether they
  /// were used: the first ones, and then those after enough motion, when any beam measured something. Throws
  /// std::invalid_argument for a pose that is not finite or a scan that is not valid.
  bool add(const grid::Rigid2& T_odom_base, const std::vector<scan::MountedScan>& scans);

  MonteCarloEstimate estimate() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace map_matcher::localization
