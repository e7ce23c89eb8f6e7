/// \file
/// What can be chosen about a search.
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

/// Options of a search: of the two stages (report sections 3.1 and 3.2), and of the proof. Their ranges stand in
/// parametersOf(). What a place has to show to be believed is no matter of the search: see belief/belief_options.hpp.
struct SearchOptions {
  std::string search = "exact";  ///< "two_stage": coarse, then fine; "exact": both, then proof and runner-up.
  double coarse_resolution =
      0.2;  ///< [m] The coarse stage runs at the halving of the map's resolution nearest to this.
  StageOptions coarse{2.0, 0.5};
  StageOptions fine{1.0, 0.1};
  double hit_tolerance = 0.05;     ///< [m] Exact: farthest that a session cell may be off a wall; 0 = on it.
  double exact_deadline = 5.0;     ///< [s] Longest time for a search, its proof included.
  double distinct_distance = 1.0;  ///< [m] Exact: places farther apart are different ones,
  double distinct_angle = 0.2;     ///< [rad] as are headings farther apart.
  int threads = 2;                 ///< Threads that search; 0 = as many as the processor has.
  int hits_sample_threshold = 0;   ///< [cells] Session cells looked at in each stage, chosen reproducibly; 0 = all.
  int min_session_cells = 100;     ///< [cells] Session maps with fewer occupied cells are not matched.
  int occupied_threshold = 65;     ///< [percent] Occupancy from which a cell is a wall.
  double session_map_cell_offset = 0.0;    ///< [cells] 0.5 for maps of slam_gmapping, which draws them half a cell off.
  double reference_map_cell_offset = 0.0;  ///< [cells] The same for the reference map.
};

/// SearchOptions::threads, or as many as the processor has.
int searchThreads(const SearchOptions& options);

/// Fewest of `num_cells` that are a share of `ratio`, at least 1.
int minCount(double ratio, int num_cells);

/// The parameters that fill `options`, by the names they have in config/map_matcher.yaml.
parameters::ParameterList parametersOf(SearchOptions& options);

}  // namespace map_matcher::search
