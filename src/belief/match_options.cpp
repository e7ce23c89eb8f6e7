#include "map_matcher/belief/match_options.hpp"

#include <algorithm>

namespace map_matcher::belief {

double smallestHitRatio(const MatchOptions& options) {
  return std::max(options.search.coarse.acceptance_ratio, options.belief.min_hit_ratio);
}

search::Demand demandOf(const MatchOptions& options) { return {smallestHitRatio(options), options.belief.min_margin}; }

parameters::ParameterList parametersOf(MatchOptions& options) {
  parameters::ParameterList all = parametersOf(options.search);
  const parameters::ParameterList belief = parametersOf(options.belief);
  all.insert(all.end(), belief.begin(), belief.end());
  return all;
}

}  // namespace map_matcher::belief
