#include "map_matcher/belief/findings.hpp"

#include <algorithm>
#include <utility>

namespace map_matcher::belief {
namespace {

constexpr double kSeenThroughWeight = 0.5;
constexpr double kRounding = 1e-9;

/// Makes a candidate's place that of the answer.
void take(const search::Place& place, search::SearchResult& result) {
  result.found = true;
  result.T_reference_session = place.T_reference_session;
  result.searched = place.searched;
  result.covariance = place.covariance;
  result.matched_cells = place.matched_cells;
  result.ratio = static_cast<double>(place.matched_cells) / std::max(1, result.total_cells);
  result.hit_cells = place.hit_cells;
  result.hit_ratio = place.hit_ratio;
}

}  // namespace

double worthOf(double hit_ratio, const FreeSpace& space) {
  return hit_ratio - kSeenThroughWeight * space.throughShare();
}

Findings rank(const std::vector<search::SearchResult>& results, std::vector<Candidate> candidates, double margin) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.worth > b.worth; });
  Findings findings;
  findings.map = candidates.empty() ? 0 : candidates.front().map;
  findings.search = results.at(findings.map);
  findings.elsewhere_bound = 0.0;
  for (const search::SearchResult& result : results) {
    findings.elsewhere_bound = std::max(findings.elsewhere_bound, result.elsewhere_bound);
    findings.search.certified = findings.search.certified && result.certified;
    findings.search.upper_bound = std::max(findings.search.upper_bound, result.upper_bound);
  }
  findings.results = results;
  findings.candidates = std::move(candidates);
  if (findings.candidates.empty()) {
    return findings;
  }
  search::SearchResult& search = findings.search;
  const Candidate& best = findings.candidates.front();
  if (search.certified) {
    take(best.place, search);
  }
  search.runner_up.reset();
  double other = 0.0;
  if (findings.candidates.size() > 1) {
    const Candidate& second = findings.candidates[1];
    other = second.worth;
    if (search.certified && best.worth - other <= margin) {
      search.runner_up = search::RunnerUp{second.place.T_reference_session, second.place.hit_ratio};
    }
  }
  search.margin = search.certified ? std::max(0.0, best.worth - std::max(other, findings.elsewhere_bound)) : 0.0;
  search.runner_up_proven =
      search.certified && findings.elsewhere_bound <= std::max(other, best.worth - margin) + kRounding;
  return findings;
}

}  // namespace map_matcher::belief
