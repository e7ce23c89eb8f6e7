#include "map_matcher/trials/session_matching.hpp"

#include <cstdint>

#include "map_matcher/evaluation/map_quality.hpp"
#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::trials {
namespace {

constexpr double kWallTolerance = 0.15;  // [m] from a wall: not falsely occupied

belief::MatchOptions checked(belief::MatchOptions options) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options)));
  return options;
}

}  // namespace

SessionMatching::SessionMatching(const grid::OccupancyGrid& reference, const belief::MatchOptions& options)
    : reference_(reference, checked(options).search), matcher_(options.search), tracker_(options) {}

void SessionMatching::match(grid::OccupancyGrid map, TrialQuery query) {
  const belief::ReferenceMaps maps{&reference_};
  const belief::Findings findings = findPlaces(matcher_, maps, map, tracker_.options(), tracker_.plan());
  query.answer = tracker_.conclude(findings, maps, map, query.T_session_base.translation()).answer;
  if (const std::optional<grid::Rigid2> T_reference_session = query.alignment()) {
    const evaluation::MapQuality quality =
        evaluation::mapQuality(reference_.grid(), map, *T_reference_session, kWallTolerance,
                               static_cast<std::int8_t>(matcher_.options().occupied_threshold));
    query.falsely_occupied = quality.falsely_occupied;
    query.occupied = quality.occupied;
    if (on_first_match_) {
      std::exchange(on_first_match_, nullptr)(map, *T_reference_session);
    }
  }
  queries_.push_back(std::move(query));
  last_map_ = std::move(map);
}

}  // namespace map_matcher::trials
