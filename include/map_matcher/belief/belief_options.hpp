/// \file
/// Every limit of what is believed.
#pragma once

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::belief {

/// What a place has to show before it is relied on. Ranges stand in parametersOf(). All of it is about exact searches:
/// the two stages alone prove nothing, and what they find is taken as it is.
struct BeliefOptions {
  double min_hit_ratio = 0.6;      ///< Smallest share of hits, beside the acceptance ratio, that is an answer.
  double min_margin = 0.1;         ///< By how much the best ratio has to exceed that of the best place elsewhere.
  bool follow_alignment = true;    ///< Whether the margin may be missed where an earlier map of the session lay.
  bool confirm_relocation = true;  ///< Whether it takes two maps to give up the place of an earlier one.
  double nearby_distance = 3.0;    ///< [m] How far the surroundings of the robot reach.
  double min_nearby_ratio = 0.5;   ///< Smallest share of hits in them that speaks for the robot's pose; 0 = any.
  double min_nearby_walls = 0.9;   ///< The same for the share of the reference map's walls found there.
};

/// The parameters that fill `options`, by the names they have in config/map_matcher.yaml.
parameters::ParameterList parametersOf(BeliefOptions& options);

}  // namespace map_matcher::belief
