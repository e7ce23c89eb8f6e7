#include "map_matcher/scrubbing/range_removal.hpp"

namespace map_matcher::scrubbing {

RangeRemoval removeRanges(const scan::ScanLayout& layout, const std::vector<float>& ranges,
                          const std::vector<Disc>& discs, const ScrubbingOptions& options, ScanScrubber& scrubber) {
  const std::vector<std::uint32_t>& beams = scrubber.beamsInside(layout, ranges, discs);
  RangeRemoval removal{ranges, {}, beams.size(), scrubber.numPoints()};
  if (static_cast<double>(beams.size()) > options.max_removed_fraction * removal.points) {
    return removal;
  }
  const float range = removedRange(options.removed_range, layout);
  for (const std::uint32_t beam : beams) {
    removal.ranges[beam] = range;
  }
  removal.removed = beams;
  return removal;
}

}  // namespace map_matcher::scrubbing
