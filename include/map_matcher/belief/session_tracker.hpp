/// \file
/// What is believed of a session, map by map.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/belief/findings.hpp"
#include "map_matcher/belief/judge.hpp"
#include "map_matcher/belief/known_place.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/place_search.hpp"
#include "map_matcher/belief/prior.hpp"
#include "map_matcher/belief/session_map_traits.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::belief {

/// What is to become of the alignment that is broadcast.
enum class Broadcast {
  kKeep,      ///< It stays as it is.
  kReplace,   ///< That of the answer takes its place.
  kWithdraw,  ///< It is not to be broadcast any more.
};

/// How a session stands.
enum class SessionState {
  kSearching,  ///< No place is known.
  kTentative,  ///< A place is, and the next map that finds it too is matched.
  kLocalized,  ///< An alignment is in use.
  kLost,       ///< An alignment was in use, but the robot is not where it says.
};

/// "searching", "tentative", "localized" or "lost".
const char* toString(SessionState state);

/// What came of a session map.
struct Decision {
  Answer answer;
  Broadcast broadcast = Broadcast::kKeep;
  SessionState state = SessionState::kSearching;
  int maps_since_proof = 0;  ///< Maps that followed the alignment in use since it was last proven.
};

/// Takes the maps of a session and what the search says of them, in their order, and decides what is believed and
/// broadcast. Node and evaluation use it alike, so that what was measured is what runs. An alignment in use stays where
/// it is until a map puts it elsewhere by more than that map's own deviation (SearchResult::covariance): what follows
/// from it does not tremble. Not thread-safe; knows no clock.
class SessionTracker {
 public:
  explicit SessionTracker(const MatchOptions& options) : options_(options) {}

  const MatchOptions& options() const { return options_; }

  /// What counts from the next map on. What is believed stays. What findPlaces() found with the options before is not
  /// to be concluded any more: it may prove too little.
  void setOptions(const MatchOptions& options) { options_ = options; }

  /// A map has come, and is going to be searched. When it begins a new session, all that was believed is forgotten, and
  /// nothing of it is to be broadcast any more: the reason why it does; else "".
  std::string arrive(const SessionMapTraits& traits);

  /// Where the next map is to be looked for first: in the place in use, unless it is time for a proof; and where its
  /// whole search begins: in the place in use, and in those of the last map that was searched.
  Plan plan() const;

  /// What findPlaces() said of `map`, the one that came last, in `maps`. `robot` is where the robot was in it at the
  /// map's stamp [m, session map frame]; nothing: not known. A map that comes twice says nothing new: it does not
  /// confirm itself.
  Decision conclude(const Findings& findings, const ReferenceMaps& maps, const grid::OccupancyGrid& map,
                    const std::optional<Eigen::Vector2d>& robot);

  SessionState state() const;

  /// The place of the last map that was matched, unless it was forgotten. It may have been withdrawn.
  const std::optional<KnownPlace>& alignment() const { return alignment_; }

  /// Somebody says where the session lies, until all is forgotten or another one says otherwise. A place in use that
  /// they do not mean has to prove itself anew, and keeps being broadcast meanwhile.
  void suppose(const Prior& prior);

  /// The reference map is another one, or time went back: nothing is believed any more, whatever comes next. The traits
  /// of the last map are kept, so that a mapper that begins anew is still told by them.
  void reset();

 private:
  Findings weigh(const Findings& findings) const;
  Circumstances circumstancesOf(const Findings& findings, const ReferenceMaps& maps, const grid::OccupancyGrid& map,
                                const std::optional<Eigen::Vector2d>& robot, std::uint64_t digest) const;
  void hold(Answer& answer) const;
  Broadcast remember(const Findings& findings, const Answer& answer, std::uint64_t digest);
  void noteStarts(const Findings& findings);
  void forgetDoubts();

  /// A place that another map has to confirm.
  struct Unconfirmed {
    KnownPlace place;
    std::uint64_t digest = 0;  // of the map that spoke for it
  };

  MatchOptions options_;
  std::optional<SessionMapTraits> last_map_;
  std::optional<KnownPlace> alignment_;
  std::optional<Unconfirmed> contender_;  // at odds with the alignment
  std::optional<Unconfirmed> tentative_;  // not likely enough on its own
  std::optional<Prior> prior_;
  std::vector<KnownPlace> starts_;  // the places of the last map that was searched, the best first
  bool robot_was_lost_ = false;
  double worth_ = 0.0;        // of the alignment, by the last map
  double probability_ = 0.0;  // of the alignment, by the last proof
  int maps_since_proof_ = 0;
};

}  // namespace map_matcher::belief
