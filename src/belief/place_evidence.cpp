#include "map_matcher/belief/place_evidence.hpp"

#include <limits>
#include <sstream>

#include "pose_text.hpp"

namespace map_matcher::belief {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kFewSeenThrough = 0.1;    // share of the walls of the right place, but for a door
constexpr double kWallsThatSayMuch = 3.0;  // [m]

}  // namespace

std::vector<Evidence> freeSpaceEvidence(const FreeSpace& space) {
  Evidence through{"seen_through", space.throughShare(), kNothing, Bearing::kSilent, MatchStatus::kDoubtful, {}};
  std::ostringstream text;
  text << space.seen_through << " m of the reference map's walls are free space in the session map, " << space.confirmed
       << " m are walls there";
  through.text = text.str();
  if (space.confirmed + space.seen_through >= kWallsThatSayMuch && space.throughShare() <= kFewSeenThrough) {
    through.bearing = Bearing::kFor;
  }
  Evidence open{"in_the_open", space.openShare(), kNothing, Bearing::kSilent, MatchStatus::kDoubtful, {}};
  text.str("");
  text << space.in_the_open << " m of the session's walls are free space in the reference map, " << space.on_walls
       << " m are walls there";
  open.text = text.str();
  Evidence agreeing{"agreeing_walls", space.agreeing(), kNothing, Bearing::kSilent, MatchStatus::kDoubtful, {}};
  text.str("");
  text << space.agreeing() << " m of walls are in both maps";
  agreeing.text = text.str();
  return {through, open, agreeing};
}

Evidence probabilityEvidence(double probability, const BeliefOptions& options, bool confirmed, bool follows) {
  Evidence evidence{"probability", probability, options.min_probability, Bearing::kFor, MatchStatus::kDoubtful, {}};
  std::ostringstream text;
  text << "the place is right with a probability of " << probability;
  if (follows) {
    evidence.bearing = Bearing::kSilent;
  } else if (confirmed && probability >= options.tentative_probability) {
    text << ", and an earlier map of the session was found there, too";
  } else if (probability < options.min_probability) {
    evidence.bearing = Bearing::kAgainst;
    text << " alone, expected min_probability = " << options.min_probability;
  }
  evidence.text = text.str();
  return evidence;
}

Evidence followedEvidence(const Findings& findings) {
  std::ostringstream text;
  text << findings.search.hit_cells << " of " << findings.search.total_cells
       << " session cells lie near walls where the place was before, at "
       << poseText(findings.search.T_reference_session);
  return {"followed", findings.candidates.front().worth, kNothing, Bearing::kFor, MatchStatus::kMatched, text.str()};
}

}  // namespace map_matcher::belief
