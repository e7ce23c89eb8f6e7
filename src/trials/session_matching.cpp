#include "map_matcher/trials/session_matching.hpp"

#include <cstdint>

#include "map_matcher/evaluation/map_quality.hpp"

namespace map_matcher::trials {
namespace {

constexpr double kWallTolerance = 0.15;  // [m] from a wall: not falsely occupied

}  // namespace

SessionMatching::SessionMatching(const grid::OccupancyGrid& reference, const search::MatchOptions& options)
    : reference_(reference), matcher_(options) {
  matcher_.setReference(reference);
}

void SessionMatching::match(grid::OccupancyGrid map, TrialQuery query) {
  search::MatchPrior prior = memory_.prior();
  prior.robot = query.T_session_base.translation();
  query.result = matcher_.match(map, prior);
  memory_.add(query.result);
  if (query.result.matched()) {
    const grid::Rigid2& T_reference_session = query.result.T_reference_session;
    const evaluation::MapQuality quality =
        evaluation::mapQuality(reference_, map, T_reference_session, kWallTolerance,
                               static_cast<std::int8_t>(matcher_.options().occupied_threshold));
    query.falsely_occupied = quality.falsely_occupied;
    query.occupied = quality.occupied;
    if (on_first_match_) {
      std::exchange(on_first_match_, nullptr)(map, T_reference_session);
    }
  }
  queries_.push_back(std::move(query));
  last_map_ = std::move(map);
}

}  // namespace map_matcher::trials
