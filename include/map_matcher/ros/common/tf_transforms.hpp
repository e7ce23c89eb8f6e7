/// \file
/// What the scrubbing room asks of tf.
#pragma once

#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "map_matcher/scrubbing/detection_poses.hpp"

namespace map_matcher::ros_common {

/// Transforms of a tf buffer. As thread-safe as that.
class TfTransforms : public scrubbing::FrameTransforms {
 public:
  /// `tf` must outlive this.
  explicit TfTransforms(const tf2::BufferCore& tf) : tf_(tf) {}

  std::optional<Eigen::Isometry3d> through(const std::string& fixed_frame, const scrubbing::FrameAt& target,
                                           const scrubbing::FrameAt& source) const override;
  std::optional<scrubbing::Stamp> newest(const std::string& target, const std::string& source) const override;
  std::optional<Eigen::Isometry3d> latest(const std::string& target, const std::string& source) const override;

 private:
  const tf2::BufferCore& tf_;
};

}  // namespace map_matcher::ros_common
