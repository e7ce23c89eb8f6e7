#include "map_matcher/search/match_options.hpp"

namespace map_matcher {

ParameterList parametersOf(MatchOptions& options) {
  return {
      {"coarse_resolution", "m",
       "The coarse stage runs at the map's resolution doubled as often as comes nearest to this.",
       &options.coarse_resolution, 0.01, 10.0},
      {"rotation_downsampling", "cells",
       "Coarse stage: cells that the farthest session cell may move in two rotation steps (eq. 4.2).",
       &options.coarse.rotation_downsampling, 0.1, 100.0},
      {"acceptance_ratio", "", "Coarse stage: smallest share of session cells on walls that is an answer.",
       &options.coarse.acceptance_ratio, 0.0, 1.0},
      {"fine_rotation_downsampling", "cells", "Fine stage: the same as rotation_downsampling.",
       &options.fine.rotation_downsampling, 0.1, 100.0},
      {"fine_acceptance_ratio", "",
       "Fine stage: smallest share of session cells on walls that is an answer; without one the coarse answer stands.",
       &options.fine.acceptance_ratio, 0.0, 1.0},
      {"hits_sample_threshold", "cells",
       "Session cells looked at in each stage, always the same ones for the same map; 0 looks at all.",
       &options.hits_sample_threshold, 0.0, 1e9},
      {"min_session_cells", "cells", "Session maps with fewer occupied cells are not matched.",
       &options.min_session_cells, 1.0, 1e9},
      {"occupied_threshold", "percent", "Occupancy from which a cell is a wall, in both maps.",
       &options.occupied_threshold, 1.0, 100.0},
      {"session_map_cell_offset", "cells",
       "How far the session map is drawn off along x and y; 0.5 for maps of slam_gmapping.",
       &options.session_map_cell_offset, -1.0, 1.0},
      {"reference_map_cell_offset", "cells",
       "How far the reference map is drawn off along x and y; 0.5 for maps of slam_gmapping.",
       &options.reference_map_cell_offset, -1.0, 1.0},
  };
}

}  // namespace map_matcher
