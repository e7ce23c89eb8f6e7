#include "map_matcher/belief/findings.hpp"

#include <algorithm>
#include <utility>

namespace map_matcher::belief {
namespace {

constexpr double kSeenThroughWeight = 0.5;
constexpr double kRounding = 1e-9;

/// What the best of the other candidates has.
struct Rivals {
  double worth = 0.0;
  double hit_ratio = 0.0;
};

Rivals rivalsOf(const Findings& findings) {
  Rivals rivals;
  for (std::size_t k = 1; k < findings.candidates.size(); ++k) {
    rivals.worth = std::max(rivals.worth, findings.candidates[k].worth);
    rivals.hit_ratio = std::max(rivals.hit_ratio, findings.candidates[k].place.hit_ratio);
  }
  if (findings.candidates.size() == 1 && findings.search.runner_up) {  // with too few hits for a candidate
    rivals.worth = rivals.hit_ratio = findings.search.runner_up->ratio;
  }
  return rivals;
}

double leadOver(const Candidate& best, const Rivals& rivals) {
  return std::max(best.worth - rivals.worth, best.place.hit_ratio - rivals.hit_ratio);
}

}  // namespace

double leadOf(const Findings& findings) {
  return findings.candidates.empty() ? 0.0 : leadOver(findings.candidates.front(), rivalsOf(findings));
}

double provenLeadOf(const Findings& findings) {
  return findings.candidates.empty()
             ? -1.0
             : findings.candidates.front().worth - std::max(rivalsOf(findings).worth, findings.elsewhere_worth);
}

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
  findings.elsewhere_worth = findings.elsewhere_bound;
  findings.results = results;
  findings.candidates = std::move(candidates);
  if (findings.candidates.empty()) {
    return findings;
  }
  search::SearchResult& search = findings.search;
  const Candidate& best = findings.candidates.front();
  if (search.certified) {
    setAnswer(search, best.place);
  }
  const Rivals rivals = rivalsOf(findings);
  const double lead = leadOver(best, rivals);
  if (!search.certified) {
    search.runner_up.reset();
  } else if (findings.candidates.size() > 1) {
    const search::Place& second = findings.candidates[1].place;
    search.runner_up = search::RunnerUp{second.T_reference_session, second.hit_ratio};
  }
  const double elsewhere = findings.elsewhere_bound;
  search.margin =
      search.certified
          ? std::max(0.0, leadOver(best, {std::max(rivals.worth, elsewhere), std::max(rivals.hit_ratio, elsewhere)}))
          : 0.0;
  search.runner_up_proven = search.certified && search.margin >= std::min(lead, margin) - kRounding;
  return findings;
}

}  // namespace map_matcher::belief
