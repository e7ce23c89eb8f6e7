#include "map_matcher/search/acceptance.hpp"

#include <sstream>

namespace map_matcher::search {
namespace {

std::string text(const grid::Rigid2& pose) {
  std::ostringstream out;
  out << "(" << pose.x << " m, " << pose.y << " m, " << pose.yaw << " rad)";
  return out.str();
}

std::string hitsText(const MatchResult& result, const MatchOptions& options) {
  std::ostringstream out;
  out << result.hit_cells << " of " << result.total_cells << " session cells lie within " << options.hit_tolerance
      << " m of walls at " << text(result.T_reference_session);
  return out.str();
}

std::string elsewhereText(const MatchResult& result) {
  std::ostringstream out;
  if (result.runner_up) {
    out << (result.runner_up_proven ? "the best place elsewhere, " : "a place elsewhere, ")
        << text(result.runner_up->T_reference_session) << ", has a ratio of " << result.runner_up->ratio;
  } else {
    out << "no place elsewhere comes closer to its ratio than " << result.margin;
  }
  return out.str();
}

Verdict notCertified(const MatchResult& result, const MatchOptions& options) {
  std::ostringstream reason;
  reason << "not proven in time (exact_deadline = " << options.exact_deadline << " s): ";
  if (result.hit_cells == 0) {
    reason << "no pose with a ratio of " << smallestHitRatio(options) << " was found so far";
  } else {
    reason << "so far " << hitsText(result, options);
  }
  if (result.certified) {
    reason << ", the best of all, but of other places it is only known that none comes closer to its ratio than "
           << result.margin;
  } else {
    reason << ", and no pose has a ratio above " << result.upper_bound;
  }
  return {MatchStatus::kNotCertified, reason.str()};
}

Verdict belowAcceptanceRatio(const MatchResult& result, const MatchOptions& options) {
  std::ostringstream reason;
  reason << "no pose puts " << smallestHitRatio(options) << " of the " << result.total_cells << " session cells within "
         << options.hit_tolerance << " m of walls of the reference map";
  return {MatchStatus::kBelowAcceptanceRatio, reason.str()};
}

Verdict ambiguous(const MatchResult& result, const MatchOptions& options) {
  std::ostringstream reason;
  reason << hitsText(result, options) << ", a ratio of " << result.hit_ratio << ", but " << elsewhereText(result)
         << "; expected a margin of min_margin = " << options.min_margin;
  return {MatchStatus::kAmbiguous, reason.str()};
}

Verdict unconfirmed(const MatchResult& result, const MatchOptions& options) {
  return {MatchStatus::kUnconfirmed,
          hitsText(result, options) + "; " + elsewhereText(result) +
              "; but an earlier map of the session was accepted at another place: the next " +
              "one has to confirm which it is"};
}

}  // namespace

Verdict judge(const MatchResult& result, const MatchOptions& options, Standing standing) {
  if (result.certified && result.hit_cells < minCount(smallestHitRatio(options), result.total_cells)) {
    return belowAcceptanceRatio(result, options);
  }
  if (!result.certified) {
    return notCertified(result, options);
  }
  const bool rivalled = result.runner_up && result.hit_ratio - result.runner_up->ratio < options.min_margin;
  const bool ahead = !rivalled && result.runner_up_proven && result.margin >= options.min_margin;
  if (!ahead && standing == Standing::kAgrees && options.follow_alignment) {
    return {MatchStatus::kMatched,
            hitsText(result, options) + ", the place of an earlier session map; " + elsewhereText(result)};
  }
  if (rivalled) {
    return ambiguous(result, options);
  }
  if (!ahead) {
    return notCertified(result, options);
  }
  if (standing == Standing::kContradicts && options.confirm_relocation) {
    return unconfirmed(result, options);
  }
  std::ostringstream reason;
  reason << hitsText(result, options) << (result.replaced ? ", a better place than that of the two stages" : "") << "; "
         << elsewhereText(result);
  return {MatchStatus::kMatched, reason.str()};
}

}  // namespace map_matcher::search
