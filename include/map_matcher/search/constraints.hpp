/// \file
/// What narrows a search; nothing needs to.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::search {

/// Heading of the session map in the reference map.
struct HeadingPrior {
  double yaw = 0.0;         ///< Yaw of T_reference_session [rad].
  double half_width = 3.2;  ///< Rotations farther from `yaw` are not searched [rad]; pi or more: all are searched.
};

/// Box of the reference map frame in which the origin of the session map frame lies.
struct WindowPrior {
  Eigen::Vector2d centre{0.0, 0.0};     ///< [m]
  Eigen::Vector2d half_size{0.0, 0.0};  ///< [m], not negative.
};

/// Optional knowledge that narrows or orders the search (report section 3.1: "prior sorting according to available
/// heading information").
struct Constraints {
  std::optional<HeadingPrior> heading;  ///< Orders the initial node list, nearest heading first, and may narrow it.
  std::optional<WindowPrior> window;    ///< Narrows the translations.
};

}  // namespace map_matcher::search
