/// \file
/// What is believed of a session, map by map.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/belief/judge.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/belief/prior.hpp"
#include "map_matcher/belief/session_map_traits.hpp"
#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/reference.hpp"
#include "map_matcher/search/search_result.hpp"

namespace map_matcher::belief {

/// What is to become of the alignment that is broadcast.
enum class Broadcast {
  kKeep,      ///< It stays as it is.
  kReplace,   ///< That of the answer takes its place.
  kWithdraw,  ///< It is not to be broadcast any more.
};

/// What came of a session map.
struct Decision {
  Answer answer;
  Broadcast broadcast = Broadcast::kKeep;
};

/// Takes the maps of a session and what the search says of them, in their order, and decides what is believed and
/// broadcast. Node and evaluation use it alike, so that what was measured is what runs. Not thread-safe; knows no
/// clock.
class SessionTracker {
 public:
  explicit SessionTracker(const MatchOptions& options) : options_(options) {}

  const MatchOptions& options() const { return options_; }

  /// A map has come, and is going to be searched. When it begins a new session, all that was believed is forgotten, and
  /// nothing of it is to be broadcast any more: the reason why it does; else "".
  std::string arrive(const SessionMapTraits& traits);

  /// What the search said of `map`, the one that came last. `robot` is where the robot was in it at the map's stamp [m,
  /// session map frame]; nothing: not known. A map that comes twice says nothing new: it does not confirm itself.
  Decision conclude(const search::SearchResult& result, const search::Reference& reference,
                    const grid::OccupancyGrid& map, const std::optional<Eigen::Vector2d>& robot);

  /// T_reference_session of the last map that was matched, unless it was forgotten. It may have been withdrawn.
  const std::optional<grid::Rigid2>& alignment() const { return alignment_; }

  /// Somebody says where the session lies, until all is forgotten or another one says otherwise.
  void suppose(const Prior& prior) { prior_ = prior; }

  /// What was supposed last.
  const std::optional<Prior>& prior() const { return prior_; }

  /// The reference map is another one, or time went back: nothing is believed any more, whatever comes next.
  void reset();

 private:
  Broadcast remember(const Answer& answer, std::uint64_t digest);

  /// A place at odds with the alignment, which the next map may confirm.
  struct Contender {
    grid::Rigid2 T_reference_session;
    std::uint64_t digest = 0;  // of the map that spoke for it
  };

  MatchOptions options_;
  std::optional<SessionMapTraits> last_map_;
  std::optional<grid::Rigid2> alignment_;
  std::optional<Contender> contender_;
  std::optional<Prior> prior_;
  bool robot_was_lost_ = false;
};

}  // namespace map_matcher::belief
