/// \file
/// The reference map in use.
#pragma once

#include <memory>
#include <string>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::ros_matching {

/// A reference map with the frame it is given in. Shared between threads, hence never changed.
struct ReferenceMap {
  grid::OccupancyGrid grid;
  std::string frame;  ///< Without a leading slash, not empty.
};

using ReferenceMapPtr = std::shared_ptr<const ReferenceMap>;

}  // namespace map_matcher::ros_matching
