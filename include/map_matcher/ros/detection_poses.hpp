/// \file
/// Where the frame of a detection lies as a later scan sees it.
#pragma once

#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher {

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

/// Looks up tf without ever waiting.
class DetectionPoses {
 public:
  /// `tf` must outlive this. `fixed_frame` does not move while the robot does (odom); empty: kSensorFrame at best.
  DetectionPoses(const tf2::BufferCore& tf, std::string fixed_frame);

  /// Of the frame and stamp of a set of detections, in the frame of a scan at its stamp.
  DetectionPose lookUp(const FrameAt& set, const FrameAt& scan) const;

 private:
  std::optional<Eigen::Isometry3d> throughFixedFrame(const FrameAt& set, const FrameAt& scan) const;
  std::optional<Stamp> newestStamp(const std::string& scan_frame) const;
  std::optional<Eigen::Isometry3d> asIfStandingStill(const std::string& set_frame, const std::string& scan_frame) const;

  const tf2::BufferCore& tf_;
  std::string fixed_frame_;
};

}  // namespace map_matcher
