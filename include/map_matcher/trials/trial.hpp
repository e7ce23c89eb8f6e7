/// \file
/// One drive through mapper and matcher, offline: what the nodes would have done with it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "map_matcher/mapping/session_mapper.hpp"
#include "map_matcher/scrubbing/people_removal.hpp"
#include "map_matcher/scrubbing/scrubbing_options.hpp"
#include "map_matcher/trials/session_matching.hpp"

namespace map_matcher::trials {

/// What a robot knew at an instant.
struct TrialStep {
  double time = 0.0;                     ///< [s]
  grid::Rigid2 T_odom_base;              ///< Odometry.
  std::optional<grid::Rigid2> truth;     ///< T_reference_base, where somebody knows it.
  std::vector<scan::MountedScan> scans;  ///< Of all lasers, at this instant.
};

/// People that a detector found in a scan of one of the lasers.
struct TrialDetections {
  double time = 0.0;      ///< Of the scan [s].
  double arrival = 0.0;   ///< When they are there [s].
  std::size_t laser = 0;  ///< Index of the laser, whose frame the positions are in.
  std::vector<scrubbing::Detection> detections;
};

/// What is done with a drive. Ranges stand in parametersOf() of the parts.
struct TrialOptions {
  mapping::SessionMapperOptions mapper;
  double map_update_interval = 5.0;  ///< [s] A map is matched after a drawn scan when the last one is older than this.
  double restart_interval = 0.0;     ///< [s] The session map is thrown away so often (report figure 20); 0: never.
  bool scrub = false;                ///< Whether scans are scrubbed before the mapper sees them.
  scrubbing::ScrubbingOptions scrubbing;
  double detection_wait = 0.0;  ///< [s] So long a scan waits for the detections made from it; 0: it never waits.
  belief::MatchOptions match;
};

/// What the mapper was given at an instant, for what is to be compared with it.
struct TrialMoment {
  double time = 0.0;                             ///< [s]
  int session = 0;                               ///< As in TrialQuery.
  double session_age = 0.0;                      ///< As in TrialQuery [s].
  double travelled = 0.0;                        ///< As in TrialQuery [m].
  grid::Rigid2 T_odom_base;                      ///< Odometry.
  std::optional<grid::Rigid2> T_reference_base;  ///< The truth, where it is known.
  std::vector<scan::MountedScan> scans;          ///< Of all lasers; scrubbed, if that was asked for.
  bool queried = false;                          ///< Whether a session map was matched.
};

/// Runs one drive. Not thread-safe.
class Trial {
 public:
  /// `reference` is what session maps are matched to. Throws std::invalid_argument that names every option out of
  /// range.
  Trial(const grid::OccupancyGrid& reference, const TrialOptions& options);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  /// Detections, in the order of their arrival; they apply to steps from then on. Those that a step is to wait for come
  /// before it.
  void add(const TrialDetections& detections);

  /// Another drive begins: the next step is the first one of a new session, whatever its time.
  void beginDrive();

  /// The next instant, in the order of time.
  void add(const TrialStep& step);

  /// What becomes of the session maps.
  SessionMatching& matching() { return matching_; }
  const SessionMatching& matching() const { return matching_; }

  /// The session map with all that was drawn so far; nothing before the first scan was.
  std::optional<grid::OccupancyGrid> sessionMap() const { return mapper_.map(); }

  /// Called at the end of each step.
  using OnMoment = std::function<void(const TrialMoment&)>;
  void onMoment(OnMoment on_moment) { on_moment_ = std::move(on_moment); }

 private:
  struct PastPose {
    double time = 0.0;
    grid::Rigid2 T_odom_base;
  };

  void beginSession(const TrialStep& step);
  void noteSession(const TrialStep& step);
  void takePending(double time);
  bool map(const TrialStep& step, const std::vector<scan::MountedScan>& scans);
  std::vector<scan::MountedScan> scansFor(const TrialStep& step);
  scan::PlanarScan scrubbed(std::size_t laser, const scan::PlanarScan& scan, double time);
  scrubbing::DetectionPose poseOf(const scrubbing::FrameAt& set, const scrubbing::FrameAt& scan) const;
  void match(const TrialStep& step);

  TrialOptions options_;
  mapping::SessionMapper mapper_;
  SessionMatching matching_;
  std::vector<scrubbing::PeopleRemoval> removals_;  // of each laser, all of which take the detections of all
  std::vector<TrialDetections> pending_;            // not there yet
  std::vector<PastPose> past_;                      // of the last moments, the present one last
  std::vector<scan::LaserMount> mounts_;            // of each laser
  OnMoment on_moment_;                              // null when nobody asked
  bool is_new_drive_ = true;
  int drive_ = -1;
  int session_ = -1;
  double session_start_ = 0.0;
  std::optional<double> last_map_;
  double travelled_ = 0.0;
  std::optional<grid::Rigid2> last_odometry_;
  std::optional<grid::Rigid2> true_alignment_;
};

}  // namespace map_matcher::trials
