#include "map_matcher/belief/belief_options.hpp"

namespace map_matcher::belief {

parameters::ParameterList parametersOf(BeliefOptions& options) {
  return {
      {"min_hit_ratio", "", "Exact search: smallest share of session cells that near to walls that is an answer.",
       &options.min_hit_ratio, 0.0, 1.0},
      {"min_margin", "",
       "Exact search: by how much the share at the best place has to exceed that at the best place elsewhere.",
       &options.min_margin, 0.0, 1.0},
      {"follow_alignment", "",
       "Exact search: accept a best place without min_margin where it is no other than that of an earlier session map.",
       &options.follow_alignment},
      {"confirm_relocation", "",
       "Exact search: accept a place other than that of an earlier session map only when the next map finds it too.",
       &options.confirm_relocation},
      {"nearby_distance", "m", "Exact search: session cells up to this far from the robot are its surroundings.",
       &options.nearby_distance, 0.1, 1000.0},
      {"min_nearby_ratio", "",
       "Exact search: the robot is lost when a smaller share of its surroundings lies near walls, 0 to never say so,",
       &options.min_nearby_ratio, 0.0, 1.0},
      {"min_nearby_walls", "",
       "and a smaller share of the reference map's walls there is in the session map; 0 to never say so.",
       &options.min_nearby_walls, 0.0, 1.0},
  };
}

}  // namespace map_matcher::belief
