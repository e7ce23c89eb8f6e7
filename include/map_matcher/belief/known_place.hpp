/// \file
/// A place in one of several reference maps.
#pragma once

#include <cstddef>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::belief {

/// Where a session map was found to lie.
struct KnownPlace {
  /// `T_reference_session` in the reference map of number `map`.
  // NOLINTNEXTLINE(google-explicit-constructor): a pose is a place
  KnownPlace(const grid::Rigid2& T, std::size_t map_number = 0) : T_reference_session(T), map(map_number) {}

  grid::Rigid2 T_reference_session;  ///< p_reference = T_reference_session * p_session.
  std::size_t map;                   ///< The number of the reference map.
};

}  // namespace map_matcher::belief
