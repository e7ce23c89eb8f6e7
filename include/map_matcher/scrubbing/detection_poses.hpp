/// \file
/// Where the frame of a detection lies as a later scan sees it.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher::scrubbing {

/// How a detection came into the frame of a scan, best first.
enum class PosePath {
  kFixedFrame,   ///< Through the fixed frame at both stamps: the motion of the robot in between is taken out.
  kNewest,       ///< The same, but at the newest transform, which is a little older than the scan.
  kSensorFrame,  ///< As if the robot had stood still since (the report's caching).
  kNone,         ///< There is no transform between the frames.
};

/// The path in words, for diagnostics.
const char* toString(PosePath path);

/// A frame at an instant.
struct FrameAt {
  const std::string& frame;
  Stamp stamp;
};

/// A pose and how it came about.
struct DetectionPose {
  PosePath path = PosePath::kNone;
  std::optional<Eigen::Isometry3d> T_scan_set;  ///< Nothing for kNone.
};

/// What is known of frames and how they move, as tf tells it. Never waits.
class FrameTransforms {
 public:
  virtual ~FrameTransforms() = default;

  /// T_target_source between frames at instants of their own, of which the fixed frame did not move from one to the
  /// other; nothing when that is not known.
  virtual std::optional<Eigen::Isometry3d> through(const std::string& fixed_frame, const FrameAt& target,
                                                   const FrameAt& source) const = 0;

  /// The latest instant at which `source` is known in `target`; zero: at all times.
  virtual std::optional<Stamp> newest(const std::string& target, const std::string& source) const = 0;

  /// T_target_source at that instant.
  virtual std::optional<Eigen::Isometry3d> latest(const std::string& target, const std::string& source) const = 0;
};

/// T_target_source at an instant, or at the newest one that is known when that is no more than `max_age` older; nothing
/// when there is none.
std::optional<Eigen::Isometry3d> poseAt(const FrameTransforms& transforms, const std::string& target,
                                        const FrameAt& source, Stamp max_age);

/// How old a transform may be and still do for what came a little later: a robot hardly moves in that time.
constexpr Stamp kMaxTransformAge = std::chrono::milliseconds(200);

/// Looks for the best way from the frame of a detection into that of a scan.
class DetectionPoses {
 public:
  /// `transforms` must outlive this. `fixed_frame` does not move while the robot does (odom); empty: kSensorFrame at
  /// best.
  DetectionPoses(const FrameTransforms& transforms, std::string fixed_frame);

  /// Of the frame and stamp of a set of detections, in the frame of a scan at its stamp.
  DetectionPose lookUp(const FrameAt& set, const FrameAt& scan) const;

 private:
  std::optional<Eigen::Isometry3d> throughFixedFrame(const FrameAt& set, const FrameAt& scan) const;
  std::optional<Eigen::Isometry3d> asIfStandingStill(const std::string& set_frame, const std::string& scan_frame) const;

  const FrameTransforms& transforms_;
  std::string fixed_frame_;
};

}  // namespace map_matcher::scrubbing
