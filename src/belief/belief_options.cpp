#include "map_matcher/belief/belief_options.hpp"

namespace map_matcher::belief {

parameters::ParameterList parametersOf(BeliefOptions& options) {
  return {
      {"min_probability", "",
       "Exact search: smallest probability of being right that makes a place an answer; higher: later, and more "
       "surely.",
       &options.min_probability, 0.0, 1.0},
      {"tentative_probability", "",
       "Exact search: a less likely place than min_probability, but not than this, waits for the next map to agree.",
       &options.tentative_probability, 0.0, 1.0},
      {"min_hit_ratio", "", "Exact search: smallest share of session cells near walls that is an answer.",
       &options.min_hit_ratio, 0.0, 1.0},
      {"min_margin", "",
       "Exact search: by how much the best place has to be worth more than the best place elsewhere; worth is the "
       "share "
       "of session cells near walls, less half that of the reference map's walls that were seen through.",
       &options.min_margin, 0.0, 1.0},
      {"maps_per_proof", "",
       "Exact search: once localized, one of so many session maps is searched as a whole; the place in use is followed "
       "in the others, unless it does not hold any more. 1: all are searched.",
       &options.maps_per_proof, 1, 1000000},
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
      {"withdraw_when_lost", "",
       "Whether the alignment is taken off tf while the robot is lost; else that is only told, and tf is wrong.",
       &options.withdraw_when_lost},
  };
}

}  // namespace map_matcher::belief
