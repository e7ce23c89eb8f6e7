/// \file
/// The map_matcher node's health on /diagnostics.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <map_matcher/MapMatch.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "map_matcher/ros/matching/reference_map.hpp"

namespace map_matcher::ros_matching {

/// What became of the session maps.
struct MatchRecord {
  std::int64_t session_maps = 0;              ///< Session maps that came.
  std::optional<ros::Time> last_session_map;  ///< Arrival of the last one.
  std::optional<MapMatch> last_report;        ///< What the last search said.
  std::optional<MapMatch> last_match;         ///< What gave the alignment in use.
  std::int64_t reports_since = 0;             ///< Reports after last_match.
  std::string new_session;                    ///< Why the session began anew; "" when a map has matched since.
  std::string robot_unknown;                  ///< Why tf did not know the robot at the last search; "" when it did.

  void add(const MapMatch& report);

  /// There is no alignment any more.
  void forgetMatch();
};

/// Once a second, by the wall clock, tells of the reference maps, of the session maps and of the alignment.
class MatchDiagnostics {
 public:
  /// What there is to tell.
  struct State {
    MatchRecord record;
    ReferenceMapList references;             ///< Empty: none yet.
    bool contested = false;                  ///< Whether another node gives the child frame of the alignment a parent.
    std::uint32_t dropped_session_maps = 0;  ///< Session maps that could not be used.
    std::uint32_t dropped_reference_maps = 0;  ///< Reference maps that could not be used.
  };

  /// `state` is called on the thread that spins. The topics are those that the maps come on.
  MatchDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node, std::function<State()> state,
                   const std::string& session_topic, const std::string& reference_topic);

 private:
  void reportReference(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void reportSession(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void reportAlignment(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  std::function<State()> look_;
  State state_;  // at the time of the report
  std::string session_topic_;
  std::string reference_topic_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace map_matcher::ros_matching
