#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"

namespace map_matcher::ros_scrubbing {

parameters::ParameterList parametersOf(LidarScrubberServerOptions& options) {
  parameters::ParameterList parameters{
      {"detection_topics", "",
       "Topics of all person detectors: geometry_msgs/PoseArray or map_matcher/PersonDetections.",
       &options.detection_topics},
      {"fixed_frame", "",
       "tf frame that does not move with the robot, to move detections with; empty: the robot is taken to stand still.",
       &options.fixed_frame},
      {"mode",
       "",
       "Whether a scan waits for the detections made from it, or never waits.",
       &options.mode,
       {},
       {},
       {"cached", "synchronised"}},
      {"sync_timeout", "s", "Longest wait in the mode synchronised.", &options.sync_timeout, 0.001, 10.0},
      {"silence_warning", "s", "A detector that says nothing for longer is a warning.", &options.silence_warning, 0.01,
       3600.0},
      {"silence_error", "s", "A detector that says nothing for longer is an error.", &options.silence_error, 0.01,
       3600.0},
      {"on_silence",
       "",
       "What becomes of scans while a detector is silent, or too late for every scan, for longer than silence_error.",
       &options.on_silence,
       {},
       {},
       {"pass", "drop"}},
      {"wall_veto_distance", "m",
       "Detections within this distance of a wall of the reference map are false, once the robot is localized; 0: none "
       "is.",
       &options.wall_veto_distance, 0.0, 1.0},
  };
  for (const parameters::Parameter& parameter : parametersOf(options.scrubbing)) {
    parameters.push_back(parameter);
  }
  return parameters;
}

}  // namespace map_matcher::ros_scrubbing
