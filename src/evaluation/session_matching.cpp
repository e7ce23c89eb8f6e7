#include "map_matcher/evaluation/session_matching.hpp"

#include <cstdint>

#include "map_matcher/evaluation/map_quality.hpp"

namespace map_matcher {
namespace {

constexpr double kWallTolerance = 0.15;  // [m] from a wall: not falsely occupied

}  // namespace

SessionMatching::SessionMatching(const OccupancyGrid& reference, const MatchOptions& options)
    : reference_(reference), matcher_(options) {
  matcher_.setReference(reference);
}

void SessionMatching::match(OccupancyGrid map, TrialQuery query) {
  MatchPrior prior;
  prior.alignment = alignment_;
  query.result = matcher_.match(map, prior);
  if (query.result.matched()) {
    alignment_ = query.result.T_reference_session;
    const MapQuality quality = mapQuality(reference_, map, *alignment_, kWallTolerance,
                                          static_cast<std::int8_t>(matcher_.options().occupied_threshold));
    query.falsely_occupied = quality.falsely_occupied;
    query.occupied = quality.occupied;
    if (on_first_match_) {
      std::exchange(on_first_match_, nullptr)(map, *alignment_);
    }
  }
  queries_.push_back(std::move(query));
  last_map_ = std::move(map);
}

}  // namespace map_matcher
