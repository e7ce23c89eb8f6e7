/// \file
/// Session maps searched in one reference map and judged on their own.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "map_matcher/belief/judge.hpp"
#include "map_matcher/belief/place_search.hpp"
#include "map_matcher/search/map_matcher.hpp"

namespace map_matcher::test {

/// Searches and judges as the node does, with what is known beside the search given by hand.
class Matcher {
 public:
  Matcher(grid::OccupancyGrid reference, const belief::MatchOptions& options = {})
      : options_(options),
        matcher_(options.search),
        reference_(std::make_shared<const search::Reference>(std::move(reference), options.search)) {}

  const search::Reference& reference() const { return *reference_; }

  belief::Answer match(const grid::OccupancyGrid& session, const search::Constraints& constraints = {},
                       const work::StopToken& stop = {}, const belief::Circumstances& circumstances = {}) const {
    return judge(findPlaces(matcher_, {reference_.get()}, session, options_, {}, constraints, stop), options_,
                 circumstances);
  }

  belief::Answer match(const grid::OccupancyGrid& session, const belief::Circumstances& circumstances,
                       const work::Deadline& deadline, const std::vector<belief::KnownPlace>& starts = {}) const {
    return judge(findPlaces(matcher_, {reference_.get()}, session, options_, starts, {}, deadline), options_,
                 circumstances);
  }

 private:
  belief::MatchOptions options_;
  search::MapMatcher matcher_;
  std::shared_ptr<const search::Reference> reference_;
};

}  // namespace map_matcher::test
