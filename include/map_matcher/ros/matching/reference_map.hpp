/// \file
/// The reference map in use.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "map_matcher/search/reference.hpp"

namespace map_matcher::ros_matching {

/// A reference map with the frame it is given in. Shared between threads, hence never changed.
struct ReferenceMap {
  ReferenceMap(grid::OccupancyGrid grid, const search::SearchOptions& options, std::string frame_id)
      : map(std::move(grid), options), frame(std::move(frame_id)) {}

  search::Reference map;  ///< What is searched in.
  std::string frame;      ///< Without a leading slash, not empty.
};

using ReferenceMapPtr = std::shared_ptr<const ReferenceMap>;

}  // namespace map_matcher::ros_matching
