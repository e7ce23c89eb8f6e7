/// \file
/// Answers of the search as messages.
#pragma once

#include <geometry_msgs/PoseWithCovariance.h>
#include <map_matcher/MapMatch.h>

#include <cstdint>
#include <string>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/belief/session_tracker.hpp"

namespace map_matcher::ros_matching {

/// All of `answer`; header, frames and counts are left to the caller.
MapMatch toMessage(const belief::Answer& answer);

/// The same of what was decided, with the maps since the proof.
MapMatch toMessage(const belief::Decision& decision);

/// The answer for a map or a request that was not searched for. `status` is INVALID_MAP, EQUAL_FRAMES,
/// INVALID_REQUEST or FAILED.
MapMatch refusal(std::uint8_t status, const std::string& reason);

/// The constant of MapMatch for a state.
std::uint8_t stateConstant(belief::SessionState state);

/// The robot's pose in the reference map, given its pose in the session map, with the covariance of the match
/// (SearchResult::covariance) carried over. z, roll and pitch, which are zero in a plane, have none. `match.status` is
/// MATCHED.
geometry_msgs::PoseWithCovariance robotPose(const MapMatch& match, const grid::Rigid2& T_session_base);

}  // namespace map_matcher::ros_matching
