#include "map_matcher/belief/match_options.hpp"

#include <algorithm>

#include "map_matcher/belief/probability.hpp"

namespace map_matcher::belief {

search::Demand demandOf(const MatchOptions& options) {
  return {options.belief.min_hit_ratio, std::max(options.belief.min_margin, kLargestMargin)};
}

parameters::ParameterList parametersOf(MatchOptions& options) {
  parameters::ParameterList all = parametersOf(options.search);
  const parameters::ParameterList belief = parametersOf(options.belief);
  all.insert(all.end(), belief.begin(), belief.end());
  return all;
}

}  // namespace map_matcher::belief
