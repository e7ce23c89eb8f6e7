/// \file
/// What can be chosen about drawing a session map.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::mapping {

/// Iterative closest point (ICP) matching of scans to what was drawn before. The defaults left 0.04 m of median path
/// error on 132 real slices of 8 to 15 m.
struct IcpOptions {
  double linear_update = 0.1;    ///< [m] Motion after which the pose is corrected again.
  double angular_update = 0.05;  ///< [rad] The same for turning.
  double max_distance = 0.4;     ///< [m] Points farther apart than this do not correspond, at first.
  double max_angle = 0.0873;     ///< [rad] The same, as seen from the robot: max_distance grows by this times range.
  double min_distance = 0.05;    ///< [m] max_distance shrinks with each convergence; below this it is done.
  double min_goodness = 0.4;     ///< Smallest share of points with a correspondence that is believed.
  int max_iterations = 100;      ///< Largest number of iterations.
};

/// Options of a SessionMapper; the first ones have slam_gmapping's names as parameters. Their ranges stand in
/// parametersOf().
struct SessionMapperOptions {
  double linear_update = 0.3;   ///< [m] Motion after which a scan is drawn (`linearUpdate`).
  double angular_update = 0.2;  ///< [rad] The same for turning (`angularUpdate`).
  double max_range = 0.0;       ///< [m] Longer ranges say nothing; 0: the scan's range_max less 1 cm (`maxRange`).
  double max_urange = 0.0;      ///< [m] Longer ranges only clear up to here; 0: as max_range (`maxUrange`).
  double delta = 0.05;          ///< [m] Edge length of a cell.
  double occ_thresh = 0.25;     ///< A cell is a wall when more than this share of its beams ended in it.
  double xmin = -10.0;          ///< [m] Extent of the first map in the session frame; it grows as needed.
  double ymin = -10.0;          ///< [m]
  double xmax = 10.0;           ///< [m]
  double ymax = 10.0;           ///< [m]
  IcpOptions icp;
};

/// The parameters that fill `options`, by the names they have in config/session_mapper.yaml.
parameters::ParameterList parametersOf(SessionMapperOptions& options);

/// What is wrong with the options, one line each: "NAME is VALUE, expected RANGE"; empty when they can be used.
std::vector<std::string> problemsWith(const SessionMapperOptions& options);

}  // namespace map_matcher::mapping
