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
  kDrawn,       ///< It corrected the pose, the robot had moved enough, and it is in the map.
  kMatched,     ///< It corrected the pose.
  kNotMoved,    ///< Not looked at: the robot has moved too little.
  kNotFitting,  ///< Too few of its points fit the map; the pose follows the odometry.
  kTooFewHits,  ///< Too few beams end at walls to tell a pose; the pose follows the odometry.
  kMapFull,     ///< It corrected the pose, but the map would have to grow beyond its limit.
};

/// What became of a scan, with the figures.
struct ScanReport {
  ScanOutcome outcome = ScanOutcome::kNotMoved;
  int hits = 0;          ///< Beams that end at walls.
  double goodness = 0.;  ///< Share of the points with a correspondence, 0 to 1; 0 when none were sought.
  std::string reason;    ///< One sentence with the figures behind the outcome.
};

/// Grid SLAM for sessions of minutes: scans are matched by ICP (mrpt::slam::CICP) to the points of the scans drawn
/// before, starting from odometry, as mrpt::slam::CMetricMapBuilderICP does; the map counts hits and visits as
/// slam_gmapping's does, but without its half cell. There is no loop closing: on drives of several hundred metres the
/// map bends. The session frame is the odometry frame at the first scan, as with slam_gmapping.
///
/// Needs no time and logs nothing. Not thread-safe.
class SessionMapper {
 public:
  /// Throws std::invalid_argument that names every option out of range.
  explicit SessionMapper(const SessionMapperOptions& options = {});
  ~SessionMapper();
  SessionMapper(SessionMapper&&) noexcept;
  SessionMapper& operator=(SessionMapper&&) noexcept;

  const SessionMapperOptions& options() const;

  /// Takes a scan, and the pose of the base in the odometry frame at the time of the scan. Scans come in the order of
  /// time; the number of their beams and the mount may change. Throws std::invalid_argument for a pose that is not
  /// finite or a scan that is not valid; the mapper is then as before.
  ScanReport addScan(const grid::Rigid2& T_odom_base, const scan::PlanarScan& scan, const scan::LaserMount& mount);

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
