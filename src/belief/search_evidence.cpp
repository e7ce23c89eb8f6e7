#include "map_matcher/belief/search_evidence.hpp"

#include <sstream>
#include <string>

#include "pose_text.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kRounding = 1e-9;

std::string hitsText(const search::SearchResult& result, const MatchOptions& options) {
  std::ostringstream out;
  out << result.hit_cells << " of " << result.total_cells << " session cells lie within "
      << options.search.hit_tolerance << " m of walls at " << poseText(result.T_reference_session);
  return out.str();
}

std::string noneCloserText(const search::SearchResult& result) {
  std::ostringstream out;
  out << "no place elsewhere comes closer to its ratio than " << result.margin;
  return out.str();
}

std::string elsewhereText(const search::SearchResult& result) {
  std::ostringstream out;
  if (result.runner_up) {
    const grid::Rigid2& elsewhere = result.runner_up->T_reference_session;
    out << (result.runner_up_proven ? "the best place elsewhere, " : "a place elsewhere, ") << poseText(elsewhere)
        << ", " << search::difference(result.T_reference_session, elsewhere, result.session_centre).distance
        << " m away, has a ratio of " << result.runner_up->ratio;
  } else {
    out << noneCloserText(result);
  }
  return out.str();
}

/// What is known when the time was over.
std::string unprovenText(const search::SearchResult& result, const MatchOptions& options) {
  std::ostringstream out;
  out << "not proven in time (exact_deadline = " << options.search.exact_deadline << " s): ";
  if (result.hit_cells == 0) {
    out << "no pose with a ratio of " << options.belief.min_hit_ratio << " was found so far";
  } else {
    out << "so far " << hitsText(result, options);
  }
  return out.str();
}

/// Whether a place elsewhere was found that comes too near to the best one.
bool isRivalled(const Findings& findings, const BeliefOptions& options) {
  if (!findings.search.runner_up) {
    return false;
  }
  const double lead =
      findings.candidates.size() > 1 ? leadOf(findings) : findings.search.hit_ratio - findings.search.runner_up->ratio;
  return lead < options.min_margin;
}

/// What is known of other places when the search for them did not come to an end.
std::string othersUnknownText(const search::SearchResult& result, const MatchOptions& options) {
  std::ostringstream text;
  if (result.ending == search::SearchEnding::kOutOfTime) {
    text << unprovenText(result, options) << ", the best of all, but";
  } else {
    text << hitsText(result, options) << ", but there are more places than are looked at:";
  }
  text << " of other places it is only known that none comes closer to its ratio than " << result.margin;
  return text.str();
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
  const double limit = options.belief.min_hit_ratio;
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
  evidence.text = hitsText(result, options) + (result.replaced ? ", a better place than the search began with" : "");
  return evidence;
}

Evidence marginEvidence(const Findings& findings, const MatchOptions& options, bool follows) {
  const search::SearchResult& result = findings.search;
  const double limit = options.belief.min_margin;
  Evidence evidence{"margin", result.margin, limit, Bearing::kFor, MatchStatus::kAmbiguous, elsewhereText(result)};
  if (!result.certified) {
    evidence.bearing = Bearing::kSilent;
    evidence.text = "nothing is known of places elsewhere";
    return evidence;
  }
  const bool rivalled = isRivalled(findings, options.belief);
  if (!rivalled && result.runner_up_proven && result.margin >= limit - kRounding) {
    return evidence;
  }
  if (!rivalled && provenLeadOf(findings) >= limit - kRounding) {  // whatever else there is
    evidence.text = noneCloserText(result);
    return evidence;
  }
  if (follows) {
    evidence.bearing = Bearing::kSilent;
    return evidence;
  }
  if (rivalled) {
    std::ostringstream text;
    text << "two places fit nearly equally well: " << hitsText(result, options) << ", a ratio of " << result.hit_ratio
         << ", but " << evidence.text << "; expected a margin of min_margin = " << limit;
    evidence.text = text.str();
  } else {
    evidence.objection = MatchStatus::kNotCertified;
    evidence.text = othersUnknownText(result, options);
  }
  evidence.bearing = Bearing::kAgainst;
  return evidence;
}

}  // namespace map_matcher::belief
