/// \file
/// What is known before a match; nothing needs to be.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::search {

/// Heading of the session map in the reference map.
struct HeadingPrior {
  double yaw = 0.0;         ///< Yaw of T_reference_session, finite [rad].
  double half_width = 3.2;  ///< Rotations farther from `yaw` are not searched [rad]; pi or more: all are searched.
};

/// Box of the reference map frame in which the origin of the session map frame lies.
struct WindowPrior {
  Eigen::Vector2d centre{0.0, 0.0};     ///< [m]
  Eigen::Vector2d half_size{0.0, 0.0};  ///< [m], not negative.
};

/// Optional knowledge that narrows or orders the search (report section 3.1: "prior sorting according to available
/// heading information").
struct MatchPrior {
  std::optional<HeadingPrior> heading;  ///< Orders the initial node list, nearest heading first, and may narrow it.
  std::optional<WindowPrior> window;    ///< Narrows the translations.
  /// T_reference_session with which an earlier map of the same session was accepted. It narrows nothing, but a best
  /// place that agrees with it needs no margin, with MatchOptions::follow_alignment.
  std::optional<grid::Rigid2> alignment;
  /// T_reference_session of the session map before, which was at odds with `alignment` (MatchStatus::kUnconfirmed): a
  /// best place that agrees with it is believed, with MatchOptions::confirm_relocation.
  std::optional<grid::Rigid2> contender;
  /// Where the robot is in the session map [m, session map frame]: a map that fits elsewhere only is
  /// MatchStatus::kRobotAstray.
  std::optional<Eigen::Vector2d> robot;
  bool robot_astray = false;  ///< Whether that was the answer for the last map of the session that fitted.
};

}  // namespace map_matcher::search
