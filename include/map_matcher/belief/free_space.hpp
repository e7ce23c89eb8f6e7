/// \file
/// What two maps of a place say of each other's walls, by the free space that they saw.
#pragma once

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/grid/seen_space.hpp"

namespace map_matcher::belief {

/// How the walls of either map lie in the other one, in metres of wall. What the other map does not know says
/// nothing. People and furniture that was moved put session walls into the open, at the right place too; but nobody
/// sees through a wall: where that was done over metres, the place is wrong, or the building has changed.
struct FreeSpace {
  double on_walls = 0.0;      ///< Of the session's walls: near walls of the reference map [m].
  double in_the_open = 0.0;   ///< Of the session's walls: in free space of the reference map [m].
  double confirmed = 0.0;     ///< Of the reference map's walls: near walls of the session map [m].
  double seen_through = 0.0;  ///< Of the reference map's walls: in free space of the session map [m].

  /// Length of the walls that are in both maps [m].
  double agreeing() const { return on_walls < confirmed ? on_walls : confirmed; }
  /// Share of the session's walls that are in the open, 0 where nothing is known.
  double openShare() const { return share(in_the_open, on_walls); }
  /// Share of the reference map's walls that were seen through, 0 where nothing is known.
  double throughShare() const { return share(seen_through, confirmed); }

 private:
  static double share(double part, double other) { return part > 0.0 ? part / (part + other) : 0.0; }
};

/// Lays `session` on `reference` at T_reference_session.
FreeSpace freeSpace(const grid::SeenSpace& reference, const grid::SeenSpace& session,
                    const grid::Rigid2& T_reference_session);

}  // namespace map_matcher::belief
