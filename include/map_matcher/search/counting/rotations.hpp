/// \file
/// The discrete rotations of the session map (report section 3.1, eq. 4.2 and 4.3; algorithm 1 line 3).
#pragma once

#include <cstdint>
#include <vector>

#include "map_matcher/search/counting/session_cells.hpp"

namespace map_matcher::search {

/// Step between two rotations [rad], eq. 4.2: dr = rotation_downsampling / sqrt(i^2 + j^2), made slightly smaller so
/// that a whole number of steps is a full turn.
double rotationStep(double rotation_downsampling, double diagonal);

/// Angles of all N rotations of a full turn [rad], from 0 on, eq. 4.3. (The report counts n from 0 to N = 2 pi / dr
/// - 1.)
std::vector<double> allRotations(double rotation_downsampling, double diagonal);

/// Angles centre + k * step, k = 0, -1, 1, -2, 2, ..., that cover centre +- half_width, not more than a full turn
/// [rad].
std::vector<double> rotationsAround(double centre, double half_width, double step);

/// Whole cells of the session's points under one rotation: floor(R(angle) * point).
struct RotatedCells {
  std::vector<std::int16_t> x;  ///< [cells of the stage]
  std::vector<std::int16_t> y;  ///< [cells of the stage]
};

RotatedCells rotate(const SessionCells& session, double angle);

}  // namespace map_matcher::search
