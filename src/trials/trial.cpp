#include "map_matcher/trials/trial.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::trials {
namespace {

constexpr double kRemembered = 2.0;  // [s] of odometry

/// The frame of a laser, named by its index.
std::string frameOf(std::size_t laser) { return std::to_string(laser); }

/// Pose of a laser that scans in a plane parallel to the floor; one that hangs upside down is turned about its x axis.
Eigen::Isometry3d toSpace(const grid::Rigid2& pose, bool upside_down) {
  Eigen::Isometry3d spatial = Eigen::Isometry3d::Identity();
  spatial.translate(Eigen::Vector3d(pose.x, pose.y, 0.0));
  spatial.rotate(Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()));
  if (upside_down) {
    spatial.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  }
  return spatial;
}

}  // namespace

Trial::Trial(const grid::OccupancyGrid& reference, const TrialOptions& options)
    : options_(options), mapper_(options.mapper), matching_(reference, options.match) {
  scrubbing::ScrubbingOptions scrubbing = options.scrubbing;
  parameters::throwIfAny(parameters::problemsOf(parametersOf(scrubbing)));
}

void Trial::add(const TrialDetections& detections) {
  if (options_.scrub) {
    pending_.push_back(detections);
  }
}

void Trial::beginDrive() {
  is_new_drive_ = true;
  past_.clear();
  pending_.clear();
  removals_.clear();
}

void Trial::add(const TrialStep& step) {
  const bool restart = options_.restart_interval > 0.0 && step.time - session_start_ >= options_.restart_interval;
  if (is_new_drive_) {
    ++drive_;
  }
  if (is_new_drive_ || restart) {
    beginSession(step);
  }
  is_new_drive_ = false;
  if (last_odometry_) {
    travelled_ += (step.T_odom_base.translation() - last_odometry_->translation()).norm();
  }
  last_odometry_ = step.T_odom_base;
  past_.push_back({step.time, step.T_odom_base});
  past_.erase(past_.begin(), std::find_if(past_.begin(), past_.end(), [&step](const PastPose& pose) {
                return pose.time >= step.time - kRemembered;
              }));
  const std::vector<scan::MountedScan> scans = scansFor(step);
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
std::vector<scan::MountedScan> Trial::scansFor(const TrialStep& step) {
  if (!options_.scrub) {
    return step.scans;
  }
  mounts_.clear();
  for (const scan::MountedScan& scan : step.scans) {
    mounts_.push_back(scan.mount);
  }
  while (removals_.size() < step.scans.size()) {
    removals_.emplace_back(options_.scrubbing, [this](const scrubbing::FrameAt& set, const scrubbing::FrameAt& scan) {
      return poseOf(set, scan);
    });
  }
  takePending(step.time + options_.detection_wait);  // what comes while the scans wait is there, hence none waits
  std::vector<scan::MountedScan> scans;
  for (std::size_t laser = 0; laser < step.scans.size(); ++laser) {
    scans.push_back({scrubbed(laser, step.scans[laser].scan, step.time), step.scans[laser].mount});
  }
  return scans;
}

/// Whether any of the scans was drawn.
bool Trial::map(const TrialStep& step, const std::vector<scan::MountedScan>& scans) {
  bool drawn = false;
  for (std::size_t laser = 0; laser < scans.size(); ++laser) {
    const scan::MountedScan& scan = scans[laser];
    const mapping::ScanReport report = mapper_.addScan(step.time, step.T_odom_base, scan.scan, scan.mount, laser);
    if (report.new_session) {
      noteSession(step);
    }
    drawn = drawn || report.outcome == mapping::ScanOutcome::kDrawn;
  }
  return drawn;
}

void Trial::beginSession(const TrialStep& step) {
  mapper_.reset();
  noteSession(step);
}

/// A session begins with this step.
void Trial::noteSession(const TrialStep& step) {
  matching_.beginSession();
  ++session_;
  session_start_ = step.time;
  last_map_.reset();
  travelled_ = 0.0;
  last_odometry_.reset();
  // The session frame is the odometry frame at the first scan.
  true_alignment_ = step.truth ? std::optional<grid::Rigid2>(*step.truth * step.T_odom_base.inverse()) : std::nullopt;
}

/// Hands the detections that are there by now to the scrubbers.
void Trial::takePending(double time) {
  const auto is_late = [time](const TrialDetections& detections) { return detections.arrival > time; };
  const auto end = std::stable_partition(pending_.begin(), pending_.end(), is_late);
  for (auto it = end; it != pending_.end(); ++it) {
    for (scrubbing::PeopleRemoval& removal : removals_) {
      removal.add({"detector", frameOf(it->laser), scrubbing::fromSeconds(it->time), it->detections});
    }
  }
  pending_.erase(end, pending_.end());
}

scan::PlanarScan Trial::scrubbed(std::size_t laser, const scan::PlanarScan& scan, double time) {
  const scrubbing::RawScan raw{frameOf(laser), scrubbing::fromSeconds(time), scan,
                               std::make_shared<const std::vector<float>>(scan.ranges)};
  scrubbing::PeopleRemoval& removal = removals_[laser];
  removal.onScan(raw);
  scan::PlanarScan result = scan;
  removal.scrub(raw, raw.stamp, [&result](const scrubbing::ScrubbedScan& scrubbed) {
    if (!scrubbed.failure.empty()) {
      throw std::runtime_error(scrubbed.failure);
    }
    result.ranges = scrubbed.removal.ranges;
  });
  return result;
}

/// Through the odometry at the time of the detections, as tf would.
scrubbing::DetectionPose Trial::poseOf(const scrubbing::FrameAt& set, const scrubbing::FrameAt& scan) const {
  const double time = scrubbing::seconds(set.stamp);
  const auto nearest = std::min_element(past_.begin(), past_.end(), [time](const PastPose& a, const PastPose& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  });
  const std::size_t laser = std::stoul(set.frame);
  if (nearest == past_.end() || laser >= mounts_.size()) {
    return {};
  }
  const scan::LaserMount& detector = mounts_[laser];
  const scan::LaserMount& mount = mounts_[std::stoul(scan.frame)];
  const grid::Rigid2 T_base_past = past_.back().T_odom_base.inverse() * nearest->T_odom_base;
  return {scrubbing::PosePath::kFixedFrame, toSpace(mount.T_base_laser, mount.upside_down).inverse() *
                                                toSpace(T_base_past, false) *
                                                toSpace(detector.T_base_laser, detector.upside_down)};
}

void Trial::match(const TrialStep& step) {
  TrialQuery query;
  query.time = step.time;
  query.drive = drive_;
  query.session = session_;
  query.session_age = step.time - session_start_;
  query.travelled = travelled_;
  query.T_session_base = mapper_.T_session_base();
  query.true_alignment = true_alignment_;
  query.truth = step.truth;
  matching_.match(*mapper_.map(), std::move(query));
}

}  // namespace map_matcher::trials
