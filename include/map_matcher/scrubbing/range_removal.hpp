/// \file
/// Writes over the ranges that end on people.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/scrubbing/scan_scrubber.hpp"
#include "map_matcher/scrubbing/scrubbing_options.hpp"

namespace map_matcher::scrubbing {

/// What became of the ranges of a scan.
struct RangeRemoval {
  std::vector<float> ranges;           ///< [m] As many as were given; bit for bit the same but for the removed ones.
  std::vector<std::uint32_t> removed;  ///< Beams that were removed, in rising order.
  std::size_t near_people = 0;         ///< Points in the discs; more than `removed` when that was too many.
  int points = 0;                      ///< Points that the scan measured.
};

/// Removes the points in the discs (report section 2.2): each becomes removedRange(). When more than
/// max_removed_fraction of the points would go, none goes. `scrubber` finds them, and keeps the points afterwards. The
/// layout and the options must be valid.
RangeRemoval removeRanges(const scan::ScanLayout& layout, const std::vector<float>& ranges,
                          const std::vector<Disc>& discs, const ScrubbingOptions& options, ScanScrubber& scrubber);

}  // namespace map_matcher::scrubbing
