/// \file
/// A simulated crowd in the scans of a recorded drive.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/scan/planar_scan.hpp"
#include "map_matcher/simulation/pedestrians.hpp"
#include "map_matcher/simulation/person_detector.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// Who walks where a recorded robot drove. Ranges stand in parametersOf() of the parts.
struct InsertedCrowdOptions {
  std::uint64_t seed = 1;  ///< Of the people, the noise and the detector, each in a stream of its own.
  PedestrianOptions pedestrians;
  PersonDetectorOptions detector;
  double robot_radius = 0.25;  ///< [m] Of the recorded robot, which people keep off.
  double sigma = 0.03;         ///< [m] Standard deviation of a range measured to a leg.
};

/// A recorded scan as it would have been in the crowd.
struct CrowdedScan {
  scan::PlanarScan scan;                     ///< Legs hide what lies behind them; other ranges stay bit for bit.
  std::optional<DetectedPeople> detections;  ///< In the frame of the laser; none: the detector was busy.
};

/// People who walk and stand in the free space of a map while a recorded robot drives through them. They keep out of
/// its way as far as they can, since it does not wait for them; whom it drives into nevertheless is not seen until it
/// has passed. The same seed and drive give the same crowd. Neither copied nor moved; not thread-safe.
class InsertedCrowd {
 public:
  /// `map`: where they walk. Throws std::invalid_argument that names every option out of its range.
  InsertedCrowd(const grid::OccupancyGrid& map, const InsertedCrowdOptions& options);
  InsertedCrowd(const InsertedCrowd&) = delete;
  InsertedCrowd& operator=(const InsertedCrowd&) = delete;

  /// Moves everybody on to `time` [s], which rises from scan to scan; by 10 s at most. `way`: where the robot really
  /// is, and then where it will be during the next second or two; at least one pose T_map_base.
  void moveOn(double time, const std::vector<grid::Rigid2>& way);

  /// The scan of a laser at the time and place of the last moveOn().
  CrowdedScan among(const scan::MountedScan& recorded);

  /// Everybody; nobody before the first moveOn().
  const std::vector<Person>& people() const;

 private:
  RobotSweep sweepOf(const std::vector<grid::Rigid2>& way) const;
  std::vector<std::size_t> legsInSight(const std::vector<Circle>& legs) const;

  World world_;
  InsertedCrowdOptions options_;
  PersonDetector detector_;
  RandomNumbers noise_;
  std::unique_ptr<Pedestrians> people_;  // none before the robot's first pose is known
  double time_ = 0.0;                    // [s]
  grid::Rigid2 T_map_base_;
};

}  // namespace map_matcher::simulation
