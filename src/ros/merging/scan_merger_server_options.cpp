#include "map_matcher/ros/merging/scan_merger_server_options.hpp"

namespace map_matcher::ros_merging {

parameters::ParameterList parametersOf(ScanMergerServerOptions& options) {
  return {
      {"scan_topics", "",
       "Topics of the scans, one for each laser of the robot, each of which stands where tf has its frame; the first "
       "one "
       "leads.",
       &options.scan_topics},
      {"base_frame", "", "tf frame of the robot, in the middle of which the merged scan is.", &options.base_frame},
      {"fixed_frame", "", "tf frame in which walls stand still while the robot moves.", &options.fixed_frame},
      {"num_beams", "", "Beams of the merged scan, all round.", &options.layout.num_beams, 8, 100000},
      {"range_min", "m", "What is nearer to the middle of the robot is left out.", &options.layout.range_min, 0.0,
       100.0},
      {"range_max", "m", "What is farther from it is left out.", &options.layout.range_max, 0.1, 1e6},
      {"max_age", "s", "Scans that are farther apart in time are not merged.", &options.times.max_age, 0.001, 10.0},
      {"patience", "s", "So long a scan waits for those of other lasers, and for tf.", &options.times.patience, 0.001,
       10.0},
      {"silence", "s", "A laser that is silent for so long is told, and no longer waited for.", &options.times.silence,
       0.1, 60.0},
  };
}

}  // namespace map_matcher::ros_merging
