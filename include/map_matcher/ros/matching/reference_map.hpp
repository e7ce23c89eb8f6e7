/// \file
/// The reference maps in use.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "map_matcher/belief/place_search.hpp"
#include "map_matcher/belief/session_map_traits.hpp"
#include "map_matcher/search/reference.hpp"

namespace map_matcher::ros_matching {

/// A reference map with the frame it is given in. Shared between threads, hence never changed.
struct ReferenceMap {
  ReferenceMap(grid::OccupancyGrid grid, const search::SearchOptions& options, std::string frame_id)
      : map(std::move(grid), options), frame(std::move(frame_id)), digest(belief::digestOf(map.grid())) {}

  search::Reference map;  ///< What is searched in.
  std::string frame;      ///< Without a leading slash, not empty.
  std::uint64_t digest;   ///< Of its cells, by which it is known again.
};

using ReferenceMapPtr = std::shared_ptr<const ReferenceMap>;

/// Floors or buildings, by their numbers; not null, and each in a frame of its own. Empty: there is none yet.
using ReferenceMapList = std::vector<ReferenceMapPtr>;

/// What is searched.
belief::ReferenceMaps searched(const ReferenceMapList& references);

/// The one in this frame, or the end.
ReferenceMapList::const_iterator findFrame(const ReferenceMapList& references, const std::string& frame);

/// The only one; null when there are none or several.
ReferenceMapPtr onlyOne(const ReferenceMapList& references);

/// Their frames in quotation marks, with commas between them.
std::string frameTexts(const ReferenceMapList& references);

}  // namespace map_matcher::ros_matching
