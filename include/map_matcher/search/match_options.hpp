/// \file
/// What can be chosen about a match.
#pragma once

#include <cstdint>
#include <string>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::search {

/// Options of one branch-and-bound search (report section 3.1).
struct StageOptions {
  double rotation_downsampling = 1.0;  ///< Cells that the farthest cell may move in two rotation steps, eq. 4.2.
  double acceptance_ratio = 0.5;       ///< Smallest share of matched session cells that is an answer.
};

/// Options of a match: of the two stages (report sections 3.1 and 3.2), and of the proof. Their ranges stand in
/// parametersOf().
struct MatchOptions {
  std::string search = "exact";  ///< "two_stage": coarse, then fine; "exact": both, then proof and runner-up.
  double coarse_resolution =
      0.2;  ///< [m] The coarse stage runs at the halving of the map's resolution nearest to this.
  StageOptions coarse{2.0, 0.5};
  StageOptions fine{1.0, 0.1};
  double hit_tolerance = 0.05;  ///< [m] Exact: farthest that a session cell may be off a wall; 0 = on it.
  double min_hit_ratio = 0.6;   ///< Exact: smallest share of hits, beside the acceptance ratio, that is an answer.
  double exact_deadline = 5.0;  ///< [s] Longest time for a search, its proof included.
  double min_margin = 0.1;      ///< Exact: by how much the best ratio has to exceed that of the best place elsewhere.
  double distinct_distance = 1.0;  ///< [m] Exact: places farther apart are different ones,
  double distinct_angle = 0.2;     ///< [rad] as are headings farther apart.
  bool follow_alignment = true;    ///< Exact: whether the margin may be missed where MatchPrior::alignment is met.
  bool confirm_relocation = true;  ///< Exact: whether it takes two maps to give up MatchPrior::alignment.
  double nearby_distance = 3.0;    ///< [m] Exact: how far the surroundings of MatchPrior::robot reach.
  double min_nearby_ratio = 0.5;   ///< Exact: smallest share of hits in them that speaks for the robot's pose; 0 = any.
  double min_nearby_walls = 0.9;   ///< Exact: the same for the share of the reference map's walls found there.
  int threads = 2;                 ///< Threads that search; 0 = as many as the processor has.
  int hits_sample_threshold = 0;   ///< [cells] Session cells looked at in each stage, chosen reproducibly; 0 = all.
  int min_session_cells = 100;     ///< [cells] Session maps with fewer occupied cells are not matched.
  int occupied_threshold = 65;     ///< [percent] Occupancy from which a cell is a wall.
  double session_map_cell_offset = 0.0;    ///< [cells] 0.5 for maps of slam_gmapping, which draws them half a cell off.
  double reference_map_cell_offset = 0.0;  ///< [cells] The same for the reference map.
};

/// Smallest share of hits that the exact search takes for an answer: the larger one of coarse.acceptance_ratio and
/// min_hit_ratio. The acceptance ratio is meant for cells on walls, and more of them lie near walls than on them.
double smallestHitRatio(const MatchOptions& options);

/// MatchOptions::threads, or as many as the processor has.
int searchThreads(const MatchOptions& options);

/// Fewest of `num_cells` that are a share of `ratio`, at least 1.
int minCount(double ratio, int num_cells);

/// The parameters that fill `options`, by the names they have in config/map_matcher.yaml.
parameters::ParameterList parametersOf(MatchOptions& options);

}  // namespace map_matcher::search
