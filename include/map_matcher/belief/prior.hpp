/// \file
/// What somebody says of the place of a session.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "map_matcher/belief/evidence.hpp"
#include "map_matcher/belief/known_place.hpp"
#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::belief {

/// Where the session is supposed to lie, before or beside what its maps show: to be weighed, not to be obeyed.
struct Prior {
  KnownPlace place;                                      ///< T_reference_session, and the reference map it is in.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< Of (x, y, yaw) of it [m, m, rad].
  std::string source;                                    ///< Who says so: "initialpose" or "saved fix".
};

/// What it says of the session that the robot is at `T_reference_base`, with this covariance of (x, y, yaw) of it, when
/// its pose in the session map is `T_session_base`; in the reference map of number `map`.
Prior priorOfRobot(const grid::Rigid2& T_reference_base, const Eigen::Matrix3d& covariance,
                   const grid::Rigid2& T_session_base, const std::string& source, std::size_t map = 0);

/// By how much more a place is worth where somebody says that the session lies: it decides between places that fit
/// equally well, and loses against one that fits better.
constexpr double kPriorWorth = 0.15;

/// Whether somebody may have meant a place: in that map, and within the deviations that 99 % of such poses have.
bool agrees(const Prior& prior, const KnownPlace& place);

/// "prior": whether it speaks for the place, which it never does against.
Evidence priorEvidence(const Prior& prior, const KnownPlace& place);

}  // namespace map_matcher::belief
