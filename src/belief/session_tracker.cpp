#include "map_matcher/belief/session_tracker.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "map_matcher/belief/agreement.hpp"
#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kDeadBand = 3.53;        // squared deviations that 68 % of poses lie within
constexpr double kLeastVariance = 1e-12;  // [m^2, rad^2] so that there is an inverse
constexpr std::size_t kMostStarts = 3;    // places of a map that the search of the next one begins in

}  // namespace

const char* toString(SessionState state) {
  switch (state) {
    case SessionState::kSearching:
      return "searching";
    case SessionState::kTentative:
      return "tentative";
    case SessionState::kLocalized:
      return "localized";
    case SessionState::kLost:
      return "lost";
  }
  return "unknown";
}

std::string SessionTracker::arrive(const SessionMapTraits& traits) {
  std::string why = last_map_ ? whyAnotherSession(*last_map_, traits) : "";
  if (!why.empty()) {
    reset();
  }
  last_map_ = traits;
  return why;
}

Plan SessionTracker::plan() const {
  Plan plan;
  if (alignment_) {
    plan.starts.push_back(*alignment_);
  }
  plan.starts.insert(plan.starts.end(), starts_.begin(), starts_.end());
  if (prior_) {
    plan.starts.push_back(prior_->place);
  }
  const bool due = maps_since_proof_ + 1 >= options_.belief.maps_per_proof;
  if (alignment_ && !robot_was_lost_ && !contender_ && !due && options_.search.search == "exact") {
    plan.follow = alignment_;
    plan.worth = worth_;
  }
  return plan;
}

Decision SessionTracker::conclude(const Findings& findings, const ReferenceMaps& maps, const grid::OccupancyGrid& map,
                                  const std::optional<Eigen::Vector2d>& robot) {
  const std::uint64_t digest = digestOf(map);
  const Findings weighed = weigh(findings);
  noteStarts(weighed);
  Decision decision;
  decision.answer = judge(weighed, options_, circumstancesOf(weighed, maps, map, robot, digest));
  hold(decision.answer);
  decision.broadcast = remember(weighed, decision.answer, digest);
  decision.maps_since_proof = maps_since_proof_;
  decision.state = state();
  return decision;
}

SessionState SessionTracker::state() const {
  if (robot_was_lost_) {
    return SessionState::kLost;
  }
  if (alignment_) {
    return SessionState::kLocalized;
  }
  return tentative_ ? SessionState::kTentative : SessionState::kSearching;
}

void SessionTracker::suppose(const Prior& prior) {
  prior_ = prior;
  if (alignment_ && !agrees(prior, *alignment_)) {
    alignment_.reset();
    forgetDoubts();
  }
}

void SessionTracker::reset() {
  std::optional<SessionMapTraits> last_map = std::move(last_map_);
  *this = SessionTracker(options_);
  last_map_ = std::move(last_map);  // whatever is forgotten, a mapper that begins anew is to be known by it
}

/// What the places are worth with what is known beside the map: that of an earlier map is given up only for one that is
/// worth more by min_margin, and what somebody says decides between equals.
Findings SessionTracker::weigh(const Findings& findings) const {
  if (findings.followed || findings.candidates.empty() || (!alignment_ && !prior_)) {
    return findings;
  }
  std::vector<Candidate> candidates = findings.candidates;
  const Eigen::Vector2d& centre = findings.search.session_centre;
  bool found_in_use = false;
  for (Candidate& candidate : candidates) {
    const bool in_use = alignment_ && isAt(candidate, centre, *alignment_, options_.search);
    const bool meant = prior_ && agrees(*prior_, {candidate.place.T_reference_session, candidate.map});
    candidate.worth += (in_use ? options_.belief.min_margin : 0.0) + (meant ? kPriorWorth : 0.0);
    found_in_use = found_in_use || in_use;
  }
  Findings weighed = rank(findings.results, std::move(candidates), demandOf(options_).margin);
  // A place that was not found may be the one in use, or meant as well as one that was.
  weighed.elsewhere_worth +=
      (alignment_ && !found_in_use ? options_.belief.min_margin : 0.0) + (prior_ ? kPriorWorth : 0.0);
  return weighed;
}

Circumstances SessionTracker::circumstancesOf(const Findings& findings, const ReferenceMaps& maps,
                                              const grid::OccupancyGrid& map,
                                              const std::optional<Eigen::Vector2d>& robot, std::uint64_t digest) const {
  const search::SearchResult& result = findings.search;
  Circumstances circumstances;
  circumstances.alignment = alignment_;
  circumstances.probability = probability_;
  circumstances.robot_was_lost = robot_was_lost_;
  if (contender_ && contender_->digest != digest) {
    circumstances.contender = contender_->place;
  }
  if (tentative_ && tentative_->digest != digest) {
    circumstances.tentative = tentative_->place;
  }
  if (prior_ && result.found) {
    circumstances.prior = priorEvidence(*prior_, {result.T_reference_session, findings.map});
  }
  if ((result.exact || findings.followed) && result.found && (robot || robot_was_lost_)) {
    // what is not seen takes nothing back
    circumstances.nearby = robot
                               ? surroundings(*maps.at(findings.map), map, options_, result.T_reference_session, *robot)
                               : Surroundings{};
  }
  return circumstances;
}

/// Keeps the alignment in use where the answer is the same place within its deviation.
void SessionTracker::hold(Answer& answer) const {
  if (!answer.matched() || !alignment_ || answer.map != alignment_->map) {
    return;
  }
  const grid::Rigid2& held = alignment_->T_reference_session;
  const Eigen::Matrix3d covariance = answer.search.covariance + kLeastVariance * Eigen::Matrix3d::Identity();
  if (grid::squaredDeviations(answer.search.T_reference_session, held, covariance) <= kDeadBand) {
    answer.search.T_reference_session = held;
  }
}

Broadcast SessionTracker::remember(const Findings& findings, const Answer& answer, std::uint64_t digest) {
  const KnownPlace place(answer.search.T_reference_session, answer.map);
  switch (answer.status) {
    case MatchStatus::kMatched:
      alignment_ = place;
      robot_was_lost_ = false;
      worth_ = findings.candidates.empty()
                   ? 0.0
                   : worthOf(findings.candidates.front().place.hit_ratio, findings.candidates.front().space);
      probability_ = answer.probability;
      maps_since_proof_ = findings.followed ? maps_since_proof_ + 1 : 0;
      forgetDoubts();
      return Broadcast::kReplace;
    case MatchStatus::kRobotLost:
      forgetDoubts();
      robot_was_lost_ = true;
      return options_.belief.withdraw_when_lost ? Broadcast::kWithdraw : Broadcast::kKeep;
    case MatchStatus::kUnconfirmed:
      contender_ = Unconfirmed{place, digest};
      break;
    case MatchStatus::kDoubtful:
      forgetDoubts();
      if (!alignment_ && answer.probability >= options_.belief.tentative_probability) {
        tentative_ = Unconfirmed{place, digest};
      }
      break;
    case MatchStatus::kBelowAcceptanceRatio:
    case MatchStatus::kNotCertified:
    case MatchStatus::kAmbiguous:
      forgetDoubts();
      break;
    case MatchStatus::kNoReference:
    case MatchStatus::kEmptyReference:
    case MatchStatus::kTooFewSessionCells:
    case MatchStatus::kSessionTooLarge:
    case MatchStatus::kStopped:
      break;  // the map was not searched
  }
  return Broadcast::kKeep;
}

void SessionTracker::noteStarts(const Findings& findings) {
  if (findings.followed || findings.candidates.empty()) {
    return;  // what was found before is all that is known
  }
  starts_.clear();
  for (std::size_t k = 0; k < std::min(kMostStarts, findings.candidates.size()); ++k) {
    starts_.emplace_back(findings.candidates[k].place.T_reference_session, findings.candidates[k].map);
  }
}

void SessionTracker::forgetDoubts() {
  contender_.reset();
  tentative_.reset();
}

}  // namespace map_matcher::belief
