/// \file
/// What can be chosen about drawing a session map.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/mapping/odometry_noise.hpp"
#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::mapping {

/// Options of a SessionMapper; the first ones have slam_gmapping's names as parameters. Their ranges stand in
/// parametersOf().
struct SessionMapperOptions {
  double linear_update = 0.3;   ///< [m] Motion after which a scan is drawn (`linearUpdate`).
  double angular_update = 0.2;  ///< [rad] The same for turning (`angularUpdate`).
  /// [s] A scan is drawn when the last one that was is older than this, though the robot stands: people walk on, and
  /// walls appear behind them; below 0: never (`temporalUpdate`).
  double temporal_update = 0.5;
  double max_range = 0.0;    ///< [m] Longer ranges say nothing; 0: the scan's range_max less 1 cm (`maxRange`).
  double max_urange = 0.0;   ///< [m] Longer ranges only clear up to here; 0: as max_range (`maxUrange`).
  double delta = 0.05;       ///< [m] Edge length of a cell.
  double occ_thresh = 0.25;  ///< A cell is a wall when more than this share of its beams ended in it.
  double xmin = -10.0;       ///< [m] Extent of the first map, along the session frame's axes, from the robot; it grows.
  double ymin = -10.0;       ///< [m]
  double xmax = 10.0;        ///< [m]
  double ymax = 10.0;        ///< [m]
  double match_linear_update = 0.1;    ///< [m] Motion after which a scan corrects the pose again.
  double match_angular_update = 0.05;  ///< [rad] The same for turning.
  double sigma = 0.05;  ///< [m] Deviation of the ends of beams from the wall that they ended at, as it was drawn.
  OdometryNoise odometry;
};

/// The parameters that fill `options`, by the names they have in config/session_mapper.yaml.
parameters::ParameterList parametersOf(SessionMapperOptions& options);

/// What is wrong with the options, one line each: "NAME is VALUE, expected RANGE"; empty when they can be used.
std::vector<std::string> problemsWith(const SessionMapperOptions& options);

}  // namespace map_matcher::mapping
