#include "map_matcher/search/map_matcher.hpp"

#include <limits>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/search/certification.hpp"
#include "map_matcher/search/robot_surroundings.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/search/stopwatch.hpp"
#include "map_matcher/search/two_stage_search.hpp"

namespace map_matcher {
namespace {

/// Resolutions that differ by less than this share are the same.
constexpr double kSameResolution = 1e-6;

/// A session map finer than the reference is searched cell by cell in the reference's cells; a coarser one needs the
/// reference map at its own resolution.
double workingResolution(const OccupancyGrid& reference, const OccupancyGrid& session) {
  const bool coarser = session.resolution() > reference.resolution() * (1.0 + kSameResolution);
  return coarser ? session.resolution() : reference.resolution();
}

}  // namespace

MapMatcher::MapMatcher(const MatchOptions& options) : options_(options) {
  throwIfAny(problemsOf(parametersOf(options_)));
}

MapMatcher::~MapMatcher() = default;
MapMatcher::MapMatcher(MapMatcher&&) noexcept = default;
MapMatcher& MapMatcher::operator=(MapMatcher&&) noexcept = default;

void MapMatcher::setReference(OccupancyGrid reference) {
  reference_ = std::make_shared<const OccupancyGrid>(std::move(reference));
  buildSearchReference(reference_->resolution());
}

MatchResult MapMatcher::match(const OccupancyGrid& session, const MatchPrior& prior, const StopToken& stop) {
  const bool exact = options_.search == "exact";
  return match(session, prior,
               Deadline(exact ? options_.exact_deadline : std::numeric_limits<double>::infinity(), stop));
}

MatchResult MapMatcher::match(const OccupancyGrid& session, const MatchPrior& prior, const Deadline& deadline) {
  if (!reference_) {
    MatchResult result;
    result.reason = "no reference map was set";
    return result;
  }
  const double resolution = workingResolution(*reference_, session);
  if (search_reference_->resolution() != resolution) {
    buildSearchReference(resolution);
  }
  Stopwatch watch;
  const bool exact = options_.search == "exact";
  const SearchSession search_session = searchSession(session, resolution, options_);
  MatchResult result = twoStageSearch(*search_reference_, search_session, options_, prior, deadline);
  if (exact) {
    result = certify(result, *search_reference_, search_session, options_, prior, deadline);
    checkRobot(result, *search_reference_, session, search_session, options_, prior);
  }
  result.search_time = watch.lap();
  result.reference_time = reference_time_;
  return result;
}

void MapMatcher::buildSearchReference(double resolution) {
  Stopwatch watch;
  search_reference_ = std::make_shared<const SearchReference>(*reference_, resolution, options_);
  reference_time_ = watch.lap();
}

}  // namespace map_matcher
