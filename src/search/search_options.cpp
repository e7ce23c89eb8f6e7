#include "map_matcher/search/search_options.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

namespace map_matcher::search {
namespace {

/// The parameters of the exact search alone.
parameters::ParameterList exactParametersOf(SearchOptions& options) {
  return {
      {"hit_tolerance", "m",
       "Exact search: a session cell counts as on a wall up to this far from one; about the noise of the scans.",
       &options.hit_tolerance, 0.0, 1.0},
      {"distinct_distance", "m",
       "Exact search: a place elsewhere puts the middle of the session map farther off than this,",
       &options.distinct_distance, 0.0, 1000.0},
      {"distinct_angle", "rad", "or turns the session map by more than this.", &options.distinct_angle, 0.0, 4.0},
      {"exact_deadline", "s", "Time after which a search of either kind ends, without an answer or without its proof.",
       &options.exact_deadline, 0.0, 3600.0},
  };
}

}  // namespace

int searchThreads(const SearchOptions& options) {
  return options.threads > 0 ? options.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int minCount(double ratio, int num_cells) { return std::max(1, static_cast<int>(std::ceil(ratio * num_cells - 1e-9))); }

parameters::ParameterList parametersOf(SearchOptions& options) {
  parameters::ParameterList parameters{
      {"search",
       "",
       "Either coarse and fine stage alone, or then the proof that no pose is better, and the best place elsewhere.",
       &options.search,
       {},
       {},
       {"two_stage", "exact"}},
      {"coarse_resolution", "m",
       "The coarse stage runs at the map's resolution doubled as often as comes nearest to this.",
       &options.coarse_resolution, 0.01, 10.0},
      {"rotation_downsampling", "cells",
       "Coarse stage: cells that the farthest session cell may move in two rotation steps (eq. 4.2).",
       &options.coarse.rotation_downsampling, 0.1, 100.0},
      {"acceptance_ratio", "",
       "Coarse stage: smallest share of session cells on walls that is an answer; to an exact search it is but a "
       "start.",
       &options.coarse.acceptance_ratio, 0.0, 1.0},
      {"fine_rotation_downsampling", "cells", "Fine stage: the same as rotation_downsampling.",
       &options.fine.rotation_downsampling, 0.1, 100.0},
      {"fine_acceptance_ratio", "",
       "Fine stage: smallest share of session cells on walls that is an answer; without one the coarse answer stands.",
       &options.fine.acceptance_ratio, 0.0, 1.0},
  };
  const parameters::ParameterList exact = exactParametersOf(options);
  parameters.insert(parameters.end(), exact.begin(), exact.end());
  const parameters::ParameterList others{
      {"threads", "", "Threads that search; 0 is as many as the processor has.", &options.threads, 0.0, 256.0},
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
  parameters.insert(parameters.end(), others.begin(), others.end());
  return parameters;
}

}  // namespace map_matcher::search
