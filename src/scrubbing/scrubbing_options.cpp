#include "map_matcher/scrubbing/scrubbing_options.hpp"

#include <limits>
#include <stdexcept>

namespace map_matcher::scrubbing {

parameters::ParameterList parametersOf(ScrubbingOptions& options) {
  return {
      {"score_threshold", "", "Smallest score of a detection that counts; PoseArray messages carry no scores.",
       &options.limits.score_threshold, 0.0, 1.0},
      {"max_detections", "", "Detections of one message that are used, the nearest first.",
       &options.limits.max_detections, 1, 100000},
      {"removal_radius", "m", "Points within this distance of a person are removed.", &options.cache.removal_radius,
       0.01, 5.0},
      {"cache_duration", "s", "A detection applies to scans whose stamps differ from its own by no more.",
       &options.cache.cache_duration, 0.0, 10.0},
      {"radius_growth", "m/s", "By this much removal_radius grows with the age of a detection.",
       &options.cache.radius_growth, 0.0, 10.0},
      {"max_removal_radius", "m", "Up to here it grows.", &options.cache.max_removal_radius, 0.01, 5.0},
      {"removed_range",
       "",
       "What a removed beam becomes: +infinity, not a number, or range_max + 1 m.",
       &options.removed_range,
       {},
       {},
       {"inf", "nan", "over_range"}},
      {"max_removed_fraction", "", "When more of a scan's points would be removed, it is passed on as it is.",
       &options.max_removed_fraction, 0.0, 1.0},
  };
}

float removedRange(const std::string& choice, const scan::ScanLayout& layout) {
  if (choice == "inf") {
    return std::numeric_limits<float>::infinity();
  }
  if (choice == "nan") {
    return std::numeric_limits<float>::quiet_NaN();
  }
  if (choice == "over_range") {
    return static_cast<float>(layout.range_max + 1.0);
  }
  throw std::invalid_argument("removed_range is \"" + choice + "\", expected inf | nan | over_range");
}

}  // namespace map_matcher::scrubbing
