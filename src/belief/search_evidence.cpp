#include "map_matcher/belief/search_evidence.hpp"

#include <sstream>
#include <string>

#include "pose_text.hpp"

namespace map_matcher::belief {
namespace {

std::string hitsText(const search::SearchResult& result, const MatchOptions& options) {
  std::ostringstream out;
  out << result.hit_cells << " of " << result.total_cells << " session cells lie within "
      << options.search.hit_tolerance << " m of walls at " << poseText(result.T_reference_session);
  return out.str();
}

std::string elsewhereText(const search::SearchResult& result) {
  std::ostringstream out;
  if (result.runner_up) {
    out << (result.runner_up_proven ? "the best place elsewhere, " : "a place elsewhere, ")
        << poseText(result.runner_up->T_reference_session) << ", has a ratio of " << result.runner_up->ratio;
  } else {
    out << "no place elsewhere comes closer to its ratio than " << result.margin;
  }
  return out.str();
}

/// What is known when the time was over.
std::string unprovenText(const search::SearchResult& result, const MatchOptions& options) {
  std::ostringstream out;
  out << "not proven in time (exact_deadline = " << options.search.exact_deadline << " s): ";
  if (result.hit_cells == 0) {
    out << "no pose with a ratio of " << smallestHitRatio(options) << " was found so far";
  } else {
    out << "so far " << hitsText(result, options);
  }
  return out.str();
}

bool isRivalled(const search::SearchResult& result, const BeliefOptions& options) {
  return result.runner_up && result.hit_ratio - result.runner_up->ratio < options.min_margin;
}

}  // namespace

Evidence ratioEvidence(const search::SearchResult& result, const MatchOptions& options) {
  const double limit = result.refined ? options.search.fine.acceptance_ratio : options.search.coarse.acceptance_ratio;
  Evidence evidence{"ratio", result.ratio, limit, Bearing::kFor, MatchStatus::kMatched, result.reason};
  if (!result.found) {
    evidence.bearing = Bearing::kAgainst;
    evidence.objection = result.ending == search::SearchEnding::kOutOfTime ? MatchStatus::kNotCertified
                                                                           : MatchStatus::kBelowAcceptanceRatio;
  }
  return evidence;
}

Evidence proofEvidence(const search::SearchResult& result, const MatchOptions& options) {
  std::ostringstream text;
  Evidence evidence{"proof", result.upper_bound - result.hit_ratio, 0.0, Bearing::kFor, MatchStatus::kNotCertified, {}};
  if (result.certified) {
    evidence.value = 0.0;
    text << "it is proven that no pose has a ratio above " << result.upper_bound;
  } else {
    evidence.bearing = Bearing::kAgainst;
    text << unprovenText(result, options) << ", and no pose has a ratio above " << result.upper_bound;
  }
  evidence.text = text.str();
  return evidence;
}

Evidence hitEvidence(const search::SearchResult& result, const MatchOptions& options) {
  const double limit = smallestHitRatio(options);
  Evidence evidence{"hit_ratio", result.hit_ratio, limit, Bearing::kFor, MatchStatus::kBelowAcceptanceRatio, {}};
  if (result.certified && result.hit_cells < search::minCount(limit, result.total_cells)) {
    std::ostringstream text;
    text << "no pose puts " << limit << " of the " << result.total_cells << " session cells within "
         << options.search.hit_tolerance << " m of walls of the reference map";
    evidence.bearing = Bearing::kAgainst;
    evidence.text = text.str();
    return evidence;
  }
  if (result.hit_cells < search::minCount(limit, result.total_cells)) {
    evidence.bearing = Bearing::kSilent;  // a better one may be there
  }
  evidence.text = hitsText(result, options) + (result.replaced ? ", a better place than that of the two stages" : "");
  return evidence;
}

Evidence marginEvidence(const search::SearchResult& result, const MatchOptions& options, bool follows) {
  const double limit = options.belief.min_margin;
  Evidence evidence{"margin", result.margin, limit, Bearing::kFor, MatchStatus::kAmbiguous, elsewhereText(result)};
  if (!result.certified) {
    evidence.bearing = Bearing::kSilent;
    evidence.text = "nothing is known of places elsewhere";
    return evidence;
  }
  const bool rivalled = isRivalled(result, options.belief);
  if (!rivalled && result.runner_up_proven && result.margin >= limit) {
    return evidence;
  }
  if (follows) {
    evidence.bearing = Bearing::kSilent;
    return evidence;
  }
  std::ostringstream text;
  if (rivalled) {
    text << hitsText(result, options) << ", a ratio of " << result.hit_ratio << ", but " << evidence.text
         << "; expected a margin of min_margin = " << limit;
  } else {
    evidence.objection = MatchStatus::kNotCertified;
    text << unprovenText(result, options)
         << ", the best of all, but of other places it is only known that none comes closer to its ratio than "
         << result.margin;
  }
  evidence.bearing = Bearing::kAgainst;
  evidence.text = text.str();
  return evidence;
}

}  // namespace map_matcher::belief
