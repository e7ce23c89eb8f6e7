/// \file
/// What can be chosen about the scan_merger.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/scan/scan_merging.hpp"
#include "map_matcher/scan/scan_sets.hpp"

namespace map_matcher::ros_merging {

/// Options of the scan_merger. Their ranges stand in parametersOf().
struct ScanMergerServerOptions {
  std::vector<std::string> scan_topics{"front_scan", "rear_scan"};  ///< One for each laser, at least one.
  std::string base_frame = "base_link";                             ///< Frame of the merged scan.
  std::string fixed_frame = "odom";  ///< Frame in which walls stand still while the robot moves.
  scan::MergedLayout layout;
  scan::ScanSetTimes times;
};

/// The parameters that fill `options`, by the names they have in config/scan_merger.yaml.
parameters::ParameterList parametersOf(ScanMergerServerOptions& options);

}  // namespace map_matcher::ros_merging
