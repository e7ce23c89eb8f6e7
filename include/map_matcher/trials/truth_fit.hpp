/// \file
/// Whether truth, scans and reference map belong together.
#pragma once

#include <optional>
#include <string>

#include "map_matcher/grid/near_walls.hpp"
#include "map_matcher/trials/trial.hpp"

namespace map_matcher::trials {

/// Looks at where the scans of a drive end when they are placed at the true poses: near walls of the map, unless it is
/// another building's or the truth is in another frame. Every tenth moment is looked at.
class TruthFit {
 public:
  explicit TruthFit(const grid::OccupancyGrid& reference);

  /// The moments of the trial; those without truth say nothing.
  void add(const TrialMoment& moment);

  /// One sentence with the figures when fewer than half of the true poses are in the map, or fewer than half of the
  /// scans' points within 0.3 m of its walls; nothing when they fit, or no truth is known.
  std::optional<std::string> problem() const;

 private:
  grid::GridGeometry geometry_;
  grid::NearWalls near_walls_;
  int moments_ = 0;
  int poses_ = 0;
  int poses_inside_ = 0;
  int points_ = 0;
  int points_near_walls_ = 0;
};

}  // namespace map_matcher::trials
