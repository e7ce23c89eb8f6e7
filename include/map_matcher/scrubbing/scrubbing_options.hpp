/// \file
/// What can be chosen about scrubbing.
#pragma once

#include <string>

#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/scan/planar_scan.hpp"
#include "map_matcher/scrubbing/detection_cache.hpp"
#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher::scrubbing {

/// Options of the scrubber (report section 2.2). Ranges stand in parametersOf().
struct ScrubbingOptions {
  DetectionLimits limits;
  CacheOptions cache;
  std::string removed_range = "inf";  ///< What a removed beam becomes, see removedRange().
  double max_removed_fraction = 0.9;  ///< [1] Of a scan's points; when more would go, the scan is left as it is.
};

/// The parameters that fill `options`, by the names they have in config/lidar_scrubber.yaml.
parameters::ParameterList parametersOf(ScrubbingOptions& options);

/// The range [m] that is written in place of a removed one: "inf" is +infinity, "nan" a quiet nan, "over_range"
/// range_max + 1 m. None of them is a measured point. Throws std::invalid_argument for another choice.
float removedRange(const std::string& choice, const scan::ScanLayout& layout);

}  // namespace map_matcher::scrubbing
