/// \file
/// Every limit of what is believed.
#pragma once

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::belief {

/// What a place has to show before it is relied on. Ranges stand in parametersOf(). All of it is about exact searches:
/// the two stages alone prove nothing, and what they find is taken as it is.
struct BeliefOptions {
  double min_probability = 0.9;        ///< Smallest probability of being right that makes a place an answer.
  double tentative_probability = 0.8;  ///< From this one on, a later map of the session that agrees makes up for it.
  double min_hit_ratio = 0.3;          ///< Smallest share of hits that is an answer; in a crowd, most cells are people.
  double min_margin = 0.1;             ///< By how much the place has to be worth more than the best place elsewhere.
  int maps_per_proof = 5;          ///< Of so many maps of a session, one is searched as a whole, once it is localized.
  bool follow_alignment = true;    ///< Whether the margin may be missed where an earlier map of the session lay.
  bool confirm_relocation = true;  ///< Whether it takes two maps to give up the place of an earlier one.
  double nearby_distance = 3.0;    ///< [m] How far the surroundings of the robot reach.
  double min_nearby_ratio = 0.5;   ///< Smallest share of hits in them that speaks for the robot's pose; 0 = any.
  double min_nearby_walls = 0.9;   ///< The same for the share of the reference map's walls found there.
  bool withdraw_when_lost = true;  ///< Whether the alignment is not broadcast while the robot is lost.
};

/// The parameters that fill `options`, by the names they have in config/map_matcher.yaml.
parameters::ParameterList parametersOf(BeliefOptions& options);

}  // namespace map_matcher::belief
