/// \file
/// Neighbouring rotations of a stage, which are looked at together before they are looked at one by one.
#pragma once

#include <vector>

#include "map_matcher/search/counting/precomputed_grids.hpp"
#include "map_matcher/search/counting/session_cells.hpp"

namespace map_matcher::search {

/// Some rotations of a search, and one that stands for them: at each of the rotations every session cell lies within
/// kBandReach cells of where it lies at the middle, along both axes.
struct RotationBand {
  std::vector<int> rotations;  ///< Indices into SearchProblem::windows.
  double middle = 0.0;         ///< [rad]
};

/// Bands that together hold all rotations of `angles` [rad], each once, in order of their angles: as wide as they may
/// be.
std::vector<RotationBand> rotationBands(const SessionCells& session, const std::vector<double>& angles);

}  // namespace map_matcher::search
