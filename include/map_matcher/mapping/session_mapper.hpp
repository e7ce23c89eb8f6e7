/// \file
/// Draws a session map from odometry and scans, where slam_gmapping is not installed.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/mapping/session_mapper_options.hpp"
#include "map_matcher/scan/planar_scan.hpp"

namespace map_matcher::mapping {

/// What became of a scan.
enum class ScanOutcome {
  kDrawn,       ///< It corrected the pose, the robot had moved or stood long enough, and it is in the map.
  kMatched,     ///< It corrected the pose.
  kNotMoved,    ///< Not looked at: the robot has moved too little.
  kNotFitting,  ///< It sees through walls of the map; the pose follows the odometry.
  kTooFewHits,  ///< Too few beams end at walls to say anything; the pose follows the odometry.
  kMapFull,     ///< It corrected the pose, but the map would have to grow beyond its limit.
};

/// What became of a scan, with the figures.
struct ScanReport {
  ScanOutcome outcome = ScanOutcome::kNotMoved;
  int hits = 0;          ///< Beams that end at walls.
  double goodness = 0.;  ///< Share of the points in known territory that lie at walls, 0 to 1; 0 when not looked at.
  std::string reason;    ///< One sentence with the figures behind the outcome.
  std::string alarm;     ///< What was wrong with the odometry and what was done about it; empty: nothing was.
  bool new_session = false;  ///< Whether the session before was ended, since scans kept contradicting its map.
};

/// Grid SLAM for sessions of minutes. The pose of a scan is what odometry and the walls drawn before say together, each
/// as far as it is sure (matchScan()): few walls in sight, or walls along one direction only, leave the odometry alone.
/// The map counts hits and visits as slam_gmapping's does, but without its half cell. There is no loop closing: on
/// drives of several hundred metres the map bends. The session frame is the odometry frame at the first scan, as with
/// slam_gmapping.
///
/// A robot that stands goes on drawing: people walk on, walls appear behind them, and what was a person becomes free.
///
/// Odometry that jumps, and odometry that stands still while the walls move, is told and corrected where the walls tell
/// how. When one scan after the other sees through walls, the session ends and a new one begins.
///
/// Reads no clock and logs nothing. Not thread-safe.
class SessionMapper {
 public:
  /// Throws std::invalid_argument that names every option out of range.
  explicit SessionMapper(const SessionMapperOptions& options = {});
  ~SessionMapper();
  SessionMapper(SessionMapper&&) noexcept;
  SessionMapper& operator=(SessionMapper&&) noexcept;

  const SessionMapperOptions& options() const;

  /// Takes a scan, its time [s], and the pose of the base in the odometry frame at that time. Scans come in the order
  /// of time; the number of their beams and the mount may change. `laser` tells the lasers of a robot apart, each of
  /// which corrects the pose and is drawn when the robot has moved since its own last scan. Throws
  /// std::invalid_argument for a time or a pose that is not finite or a scan that is not valid; the mapper is then as
  /// before.
  ScanReport addScan(double time, const grid::Rigid2& T_odom_base, const scan::PlanarScan& scan,
                     const scan::LaserMount& mount, std::size_t laser = 0);

  /// Whether a scan was drawn since the start or the last reset().
  bool hasMap() const;

  /// Pose of the base at the last scan; identity before the first.
  grid::Rigid2 T_session_base() const;

  /// The correction of the odometry: T_session_base = T_session_odom * T_odom_base. Identity before the first scan.
  grid::Rigid2 T_session_odom() const;

  /// The map with values kUnknown, kFree and kOccupied; nullopt before the first scan was drawn.
  std::optional<grid::OccupancyGrid> map() const;

  /// Forgets everything but the options: the next scan begins a new session.
  void reset();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace map_matcher::mapping
