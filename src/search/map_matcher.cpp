#include "map_matcher/search/map_matcher.hpp"

#include <limits>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/search/exact/certification.hpp"
#include "map_matcher/search/robot_surroundings.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/two_stage/two_stage_search.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

/// Resolutions that differ by less than this share are the same.
constexpr double kSameResolution = 1e-6;

/// A session map finer than the reference is searched cell by cell in the reference's cells; a coarser one needs the
/// reference map at its own resolution.
double workingResolution(const grid::OccupancyGrid& reference, const grid::OccupancyGrid& session) {
  const bool coarser = session.resolution() > reference.resolution() * (1.0 + kSameResolution);
  return coarser ? session.resolution() : reference.resolution();
}

}  // namespace

MapMatcher::MapMatcher(const MatchOptions& options) : options_(options) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options_)));
}

MapMatcher::~MapMatcher() = default;
MapMatcher::MapMatcher(MapMatcher&&) noexcept = default;
MapMatcher& MapMatcher::operator=(MapMatcher&&) noexcept = default;

bool MapMatcher::setReference(grid::OccupancyGrid reference, const work::StopToken& stop) {
  auto taken = std::make_shared<const grid::OccupancyGrid>(std::move(reference));
  Built built = build(*taken, taken->resolution(), stop);
  if (!built.reference) {
    return false;
  }
  reference_ = std::move(taken);
  built_ = std::move(built);
  return true;
}

MatchResult MapMatcher::match(const grid::OccupancyGrid& session, const MatchPrior& prior,
                              const work::StopToken& stop) {
  const std::optional<MatchResult> refusal = prepareFor(session, stop);
  return refusal ? *refusal : search(session, prior, work::Deadline(options_.exact_deadline, stop));
}

MatchResult MapMatcher::match(const grid::OccupancyGrid& session, const MatchPrior& prior,
                              const work::Deadline& deadline) {
  const std::optional<MatchResult> refusal = prepareFor(session, deadline.stop());
  return refusal ? *refusal : search(session, prior, deadline);
}

/// Builds what the session map needs of the reference map, unless it is there. What there is to say when it is not
/// then.
std::optional<MatchResult> MapMatcher::prepareFor(const grid::OccupancyGrid& session, const work::StopToken& stop) {
  MatchResult refusal;
  if (!reference_) {
    refusal.reason = "no reference map was set";
    return refusal;
  }
  const double resolution = workingResolution(*reference_, session);
  if (built_.reference->resolution() == resolution) {
    return std::nullopt;
  }
  Built built = build(*reference_, resolution, stop);
  if (!built.reference) {
    refusal.status = MatchStatus::kStopped;
    refusal.reason = "the search was stopped while the reference map was prepared for the session map's resolution";
    return refusal;
  }
  built_ = std::move(built);
  return std::nullopt;
}

MatchResult MapMatcher::search(const grid::OccupancyGrid& session, const MatchPrior& prior,
                               const work::Deadline& deadline) const {
  work::Stopwatch watch;
  const SearchReference& reference = *built_.reference;
  const SearchSession search_session = searchSession(session, reference.resolution(), options_);
  MatchResult result = twoStageSearch(reference, search_session, options_, prior, deadline);
  if (options_.search == "exact") {
    result = certify(result, reference, search_session, options_, prior, deadline);
    checkRobot(result, reference, session, search_session, options_, prior);
  }
  result.search_time = watch.lap();
  result.reference_time = built_.time;
  return result;
}

MapMatcher::Built MapMatcher::build(const grid::OccupancyGrid& reference, double resolution,
                                    const work::StopToken& stop) const {
  work::Stopwatch watch;
  try {
    const work::Deadline no_deadline(std::numeric_limits<double>::infinity(), stop);
    auto built = std::make_shared<const SearchReference>(reference, resolution, options_, no_deadline);
    return {std::move(built), watch.lap()};
  } catch (const work::DeadlinePassed&) {
    return {};
  }
}

}  // namespace map_matcher::search
