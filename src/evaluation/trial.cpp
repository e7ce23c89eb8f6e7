#include "map_matcher/evaluation/trial.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/scrubbing/range_removal.hpp"

namespace map_matcher {
namespace {

constexpr double kRemembered = 2.0;  // [s] of odometry

Stamp stampOf(double time) { return std::chrono::duration_cast<Stamp>(std::chrono::duration<double>(time)); }

/// Pose of a laser that scans in a plane parallel to the floor; one that hangs upside down is turned about its x axis.
Eigen::Isometry3d toSpace(const Rigid2& pose, bool upside_down) {
  Eigen::Isometry3d spatial = Eigen::Isometry3d::Identity();
  spatial.translate(Eigen::Vector3d(pose.x, pose.y, 0.0));
  spatial.rotate(Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()));
  if (upside_down) {
    spatial.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  }
  return spatial;
}

}  // namespace

Trial::Trial(const OccupancyGrid& reference, const TrialOptions& options)
    : options_(options), mapper_(options.mapper), matching_(reference, options.match), cache_(options.scrubbing.cache) {
  ScrubbingOptions scrubbing = options.scrubbing;
  throwIfAny(problemsOf(parametersOf(scrubbing)));
}

void Trial::add(const TrialDetections& detections) {
  if (options_.scrub) {
    pending_.push_back(detections);
  }
}

void Trial::add(const TrialStep& step) {
  const bool restart = options_.restart_interval > 0.0 && step.time - session_start_ >= options_.restart_interval;
  if (session_ < 0 || restart) {
    beginSession(step);
  }
  if (last_odometry_) {
    travelled_ += (step.T_odom_base.translation() - last_odometry_->translation()).norm();
  }
  last_odometry_ = step.T_odom_base;
  past_.push_back({step.time, step.T_odom_base});
  past_.erase(past_.begin(), std::find_if(past_.begin(), past_.end(), [&step](const PastPose& pose) {
                return pose.time >= step.time - kRemembered;
              }));
  takePending(step.time + options_.detection_wait);
  const std::vector<MountedScan> scans = scansFor(step);
  const bool drawn = map(step, scans);
  const bool queried = drawn && (!last_map_ || step.time - *last_map_ > options_.map_update_interval);
  if (queried) {
    last_map_ = step.time;
    match(step);
  }
  if (on_moment_) {
    on_moment_(
        {step.time, session_, step.time - session_start_, travelled_, step.T_odom_base, step.truth, scans, queried});
  }
}

/// The scans as the mapper is to see them.
std::vector<MountedScan> Trial::scansFor(const TrialStep& step) {
  if (!options_.scrub) {
    return step.scans;
  }
  mounts_.clear();
  for (const MountedScan& scan : step.scans) {
    mounts_.push_back(scan.mount);
  }
  std::vector<MountedScan> scans;
  for (const MountedScan& scan : step.scans) {
    scans.push_back({scrubbed(scan, step), scan.mount});
  }
  cache_.forget(stampOf(step.time));
  return scans;
}

/// Whether any of the scans was drawn.
bool Trial::map(const TrialStep& step, const std::vector<MountedScan>& scans) {
  bool drawn = false;
  for (const MountedScan& scan : scans) {
    const ScanReport report = mapper_.addScan(step.T_odom_base, scan.scan, scan.mount);
    drawn = drawn || report.outcome == ScanOutcome::kDrawn;
  }
  return drawn;
}

void Trial::beginSession(const TrialStep& step) {
  mapper_.reset();
  matching_.beginSession();
  ++session_;
  session_start_ = step.time;
  last_map_.reset();
  travelled_ = 0.0;
  last_odometry_.reset();
  // The session frame is the odometry frame at the first scan.
  true_alignment_ = step.truth ? std::optional<Rigid2>(*step.truth * step.T_odom_base.inverse()) : std::nullopt;
}

/// Hands the detections that are there by now to the cache.
void Trial::takePending(double time) {
  const auto is_late = [time](const TrialDetections& detections) { return detections.arrival > time; };
  const auto end = std::stable_partition(pending_.begin(), pending_.end(), is_late);
  for (auto it = end; it != pending_.end(); ++it) {
    DetectionSet set{"detector", std::to_string(it->laser), stampOf(it->time), it->detections};
    applyLimits(set, options_.scrubbing.limits);
    cache_.add(std::move(set));
  }
  pending_.erase(end, pending_.end());
}

PlanarScan Trial::scrubbed(const MountedScan& scan, const TrialStep& step) {
  const std::vector<Disc>& discs =
      cache_.discsAt(stampOf(step.time), [&](const DetectionSet& set) { return poseOf(set, scan, step); });
  return {scan.scan, removeRanges(scan.scan, scan.scan.ranges, discs, options_.scrubbing, scrubber_).ranges};
}

/// Through the odometry at the time of the detections, as tf would.
std::optional<Eigen::Isometry3d> Trial::poseOf(const DetectionSet& set, const MountedScan& scan,
                                               const TrialStep& step) const {
  const double time = seconds(set.stamp);
  const auto nearest = std::min_element(past_.begin(), past_.end(), [time](const PastPose& a, const PastPose& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  });
  const std::size_t laser = std::stoul(set.frame);
  if (nearest == past_.end() || laser >= mounts_.size()) {
    return std::nullopt;
  }
  const LaserMount& detector = mounts_[laser];
  const Rigid2 T_base_past = step.T_odom_base.inverse() * nearest->T_odom_base;
  return toSpace(scan.mount.T_base_laser, scan.mount.upside_down).inverse() * toSpace(T_base_past, false) *
         toSpace(detector.T_base_laser, detector.upside_down);
}

void Trial::match(const TrialStep& step) {
  TrialQuery query;
  query.time = step.time;
  query.session = session_;
  query.session_age = step.time - session_start_;
  query.travelled = travelled_;
  query.T_session_base = mapper_.T_session_base();
  query.true_alignment = true_alignment_;
  query.truth = step.truth;
  matching_.match(*mapper_.map(), std::move(query));
}

}  // namespace map_matcher
