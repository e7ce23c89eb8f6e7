#include "map_matcher/belief/place_search.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "map_matcher/belief/agreement.hpp"

namespace map_matcher::belief {
namespace {

/// The exact search of one map, and the candidates that it finds.
class ExactSearch {
 public:
  ExactSearch(const search::MapMatcher& matcher, const grid::OccupancyGrid& session, const MatchOptions& options)
      : matcher_(matcher),
        session_(session),
        options_(options),
        seen_(session, options.search.session_map_cell_offset, options.search.occupied_threshold) {}

  std::optional<Findings> follow(const search::Reference& reference, const Plan& plan, const work::StopToken& stop) {
    const search::SearchResult result =
        matcher_.follow(reference, session_, plan.follow->T_reference_session, demandOf(options_), stop);
    if (!result.found || result.places.empty()) {
      return std::nullopt;
    }
    const Candidate candidate = candidateOf(reference, plan.follow->map, result.places.front());
    if (!isAt(candidate, result.session_centre, *plan.follow, options_.search) ||
        candidate.worth < plan.worth - kFollowedLoss) {
      return std::nullopt;
    }
    Findings findings;
    findings.search = result;
    findings.map = plan.follow->map;
    findings.candidates = {candidate};
    findings.followed = true;
    return findings;
  }

  Findings searchAll(const ReferenceMaps& maps, const std::vector<KnownPlace>& starts,
                     const search::Constraints& constraints, const work::Deadline& deadline) {
    starts_ = starts;
    results_.resize(maps.size());
    if (maps.size() == 1) {
      search(*maps.front(), 0, std::nullopt, constraints, deadline);
    } else {
      searchSeveral(maps, constraints, deadline);
    }
    return rank(results_, candidates_, demandOf(options_).margin);
  }

 private:
  /// The map of the likeliest start first, then in the order of what a glance finds in them: once the right one is
  /// searched, the others are ruled out by what would have to be as good.
  void searchSeveral(const ReferenceMaps& maps, const search::Constraints& constraints,
                     const work::Deadline& deadline) {
    const double easily = std::max(options_.search.coarse.acceptance_ratio, options_.belief.min_hit_ratio);
    std::vector<search::SearchResult> glances = glanceAt(maps, easily, constraints, deadline);
    if (std::none_of(glances.begin(), glances.end(), [](const search::SearchResult& one) { return one.found; })) {
      glances = glanceAt(maps, (easily + options_.belief.min_hit_ratio) / 2.0, constraints, deadline);
    }
    std::vector<std::size_t> numbers(maps.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::stable_sort(numbers.begin(), numbers.end(),
                     [&glances](std::size_t a, std::size_t b) { return glances[a].ratio > glances[b].ratio; });
    std::stable_partition(numbers.begin(), numbers.end(),
                          [this](std::size_t map) { return !starts_.empty() && map == starts_.front().map; });
    for (const std::size_t map : numbers) {
      search(*maps[map], map, glances[map], constraints, deadline);
    }
  }

  /// What a glance finds in each map with at least this share of hits; the smaller it is, the longer that takes.
  std::vector<search::SearchResult> glanceAt(const ReferenceMaps& maps, double hit_ratio,
                                             const search::Constraints& constraints,
                                             const work::Deadline& deadline) const {
    search::Demand demand = demandOf(options_);
    demand.min_hit_ratio = hit_ratio;
    std::vector<search::SearchResult> glances;
    for (const search::Reference* map : maps) {
      glances.push_back(matcher_.glance(*map, session_, demand, constraints, deadline));
    }
    return glances;
  }

  void search(const search::Reference& reference, std::size_t map, const std::optional<search::SearchResult>& glance,
              const search::Constraints& constraints, const work::Deadline& deadline) {
    search::Demand demand = demandOf(options_);
    demand.min_hit_ratio = std::max(demand.min_hit_ratio, best_worth_ - demand.margin);
    for (const KnownPlace& start : starts_) {
      if (start.map == map) {
        demand.starts.push_back(start.T_reference_session);
      }
    }
    std::vector<Candidate> judged;  // more than there are places: where the search begins is judged as well
    demand.worth = [&](const search::Place& place) {
      judged.push_back(candidateOf(reference, map, place));
      return judged.back().worth;
    };
    results_[map] = glance ? matcher_.matchFrom(*glance, reference, session_, demand, constraints, deadline)
                           : matcher_.match(reference, session_, demand, constraints, deadline);
    for (const search::Place& place : results_[map].places) {
      const auto known = std::find_if(judged.begin(), judged.end(), [&place](const Candidate& candidate) {
        return isSame(candidate.place.T_reference_session, place.T_reference_session);
      });
      candidates_.push_back(known != judged.end() ? *known : candidateOf(reference, map, place));
      candidates_.back().place = place;
      best_worth_ = std::max(best_worth_, candidates_.back().worth);
    }
  }

  static bool isSame(const grid::Rigid2& a, const grid::Rigid2& b) {
    return a.x == b.x && a.y == b.y && a.yaw == b.yaw;
  }

  Candidate candidateOf(const search::Reference& reference, std::size_t map, const search::Place& place) const {
    const FreeSpace space = freeSpace(reference.seen(), seen_, place.T_reference_session);
    return {place, space, map, worthOf(place.hit_ratio, space)};
  }

  const search::MapMatcher& matcher_;
  const grid::OccupancyGrid& session_;
  const MatchOptions& options_;
  grid::SeenSpace seen_;
  std::vector<KnownPlace> starts_;
  double best_worth_ = 0.0;
  std::vector<search::SearchResult> results_;
  std::vector<Candidate> candidates_;
};

/// The answer of the two stages that has most cells on walls.
Findings searchInTwoStages(const search::MapMatcher& matcher, const ReferenceMaps& maps,
                           const grid::OccupancyGrid& session, const MatchOptions& options,
                           const search::Constraints& constraints, const work::Deadline& deadline) {
  Findings best;
  for (std::size_t map = 0; map < maps.size(); ++map) {
    const search::SearchResult result = matcher.match(*maps[map], session, demandOf(options), constraints, deadline);
    if (map == 0 || (result.found && (!best.search.found || result.ratio > best.search.ratio))) {
      best.search = result;
      best.map = map;
    }
  }
  return best;
}

bool isExact(const MatchOptions& options) { return options.search.search == "exact"; }

/// Builds what depends only on the reference maps; the time that it took [s].
double prepare(const ReferenceMaps& maps, double session_resolution, bool exact, const work::StopToken& stop) {
  double time = 0.0;
  for (const search::Reference* map : maps) {
    time += map->at(session_resolution, stop).time;
    if (exact && !stop.stopRequested()) {
      map->seen();
    }
  }
  return time;
}

}  // namespace

Findings findPlaces(const search::MapMatcher& matcher, const ReferenceMaps& maps, const grid::OccupancyGrid& session,
                    const MatchOptions& options, const Plan& plan, const search::Constraints& constraints,
                    const work::StopToken& stop) {
  const double reference_time = prepare(maps, session.resolution(), isExact(options), stop);
  Findings findings;
  if (isExact(options)) {
    ExactSearch search(matcher, session, options);
    if (plan.follow) {
      if (const std::optional<Findings> followed = search.follow(*maps.at(plan.follow->map), plan, stop)) {
        return *followed;
      }
    }
    findings = search.searchAll(maps, plan.starts, constraints, work::Deadline(options.search.exact_deadline, stop));
  } else {
    findings = searchInTwoStages(matcher, maps, session, options, constraints,
                                 work::Deadline(options.search.exact_deadline, stop));
  }
  findings.search.reference_time = reference_time;
  return findings;
}

Findings findPlaces(const search::MapMatcher& matcher, const ReferenceMaps& maps, const grid::OccupancyGrid& session,
                    const MatchOptions& options, const std::vector<KnownPlace>& starts,
                    const search::Constraints& constraints, const work::Deadline& deadline) {
  return isExact(options) ? ExactSearch(matcher, session, options).searchAll(maps, starts, constraints, deadline)
                          : searchInTwoStages(matcher, maps, session, options, constraints, deadline);
}

}  // namespace map_matcher::belief
