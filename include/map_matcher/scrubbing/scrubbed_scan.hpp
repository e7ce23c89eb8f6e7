/// \file
/// A scan before it is scrubbed and after.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "map_matcher/scan/planar_scan.hpp"
#include "map_matcher/scrubbing/detections.hpp"
#include "map_matcher/scrubbing/range_removal.hpp"

namespace map_matcher::scrubbing {

/// A scan that is to lose its people.
struct RawScan {
  std::string frame;
  Stamp stamp{0};
  scan::ScanLayout layout;
  std::shared_ptr<const std::vector<float>> ranges;  ///< [m] Never null.
};

/// What became of a scan.
struct ScrubbedScan {
  RangeRemoval removal;
  bool answered = true;  ///< Whether its detections came; false: it waited for them in vain.
  std::string failure;   ///< Why it could not be scrubbed, so that its ranges are those that came; empty: it was.

  /// Whether max_removed_fraction was exceeded.
  bool tooMany() const { return removal.near_people > removal.removed.size(); }
};

/// Takes a scan that was scrubbed.
using HandOn = std::function<void(const ScrubbedScan&)>;

}  // namespace map_matcher::scrubbing
