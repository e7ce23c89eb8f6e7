/// \file
/// What can be chosen about the lidar_scrubber.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/scrubbing/scrubbing_options.hpp"

namespace map_matcher::ros_scrubbing {

/// Options of the lidar_scrubber. Their ranges stand in parametersOf().
struct LidarScrubberServerOptions {
  std::vector<std::string> detection_topics{"dr_spaam_detections"};  ///< One for each detector, at least one.
  std::string fixed_frame = "odom";  ///< Frame in which people stand still while the robot moves; empty: none.
  std::string mode = "cached";       ///< cached: never waits; synchronised: waits for the scan's own detections.
  double sync_timeout = 0.1;         ///< [s] The longest wait of synchronised.
  double silence_warning = 1.0;      ///< [s] A detector silent for longer is a warning.
  double silence_error = 5.0;        ///< [s] A detector silent for longer is an error.
  std::string on_silence = "pass";   ///< What becomes of scans then: pass | drop.
  double wall_veto_distance = 0.0;   ///< [m] Detections so near to walls of the reference map are false; 0: none.
  scrubbing::ScrubbingOptions scrubbing;

  bool waits() const { return mode == "synchronised"; }  ///< Whether scans wait for their detections.
};

/// The parameters that fill `options`, by the names they have in config/lidar_scrubber.yaml.
parameters::ParameterList parametersOf(LidarScrubberServerOptions& options);

}  // namespace map_matcher::ros_scrubbing
