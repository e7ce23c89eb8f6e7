/// \file
/// What a person detector said about one scan.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace map_matcher::scrubbing {

/// Time since the epoch of whoever stamps, exact to the nanosecond, so that stamps can be compared for equality.
using Stamp = std::chrono::nanoseconds;

/// Seconds as a number.
inline double seconds(Stamp duration) { return std::chrono::duration<double>(duration).count(); }

/// The nearest stamp to a number of seconds, which is to be finite and of less than 292 years.
inline Stamp fromSeconds(double seconds) { return Stamp(static_cast<std::int64_t>(std::llround(seconds * 1e9))); }

/// A person that was detected.
struct Detection {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< Between the legs, in the frame of the set [m].
  double score = 1.0;                       ///< Confidence, 0 to 1; 1 where the detector tells none.
};

/// The people of one message. An empty set says that nobody is there.
struct DetectionSet {
  std::string source;  ///< Name of the detector.
  std::string frame;   ///< Frame of the positions.
  Stamp stamp{0};      ///< When the scan was taken that the detector looked at.
  std::vector<Detection> detections;
};

/// Which detections are used at all.
struct DetectionLimits {
  double score_threshold = 0.4;  ///< Smallest score that counts (report section 2.2).
  int max_detections = 500;      ///< Of one set; the nearest to the frame's origin are kept.
};

/// How many detections of a set were left out, by the reason.
struct LeftOut {
  int not_finite = 0;  ///< Position or score is nan or inf, or the position is more than 10 km away.
  int low_score = 0;   ///< Score below score_threshold.
  int too_many = 0;    ///< Beyond max_detections.

  int total() const { return not_finite + low_score + too_many; }
};

/// Takes out of the set what the limits do not let through. A score of exactly score_threshold counts.
LeftOut applyLimits(DetectionSet& set, const DetectionLimits& limits);

/// Whether a detection of a set is false, as when it lies on a wall.
using Veto = std::function<bool(const Detection&)>;

/// Takes the false detections out of the set and returns how many those were; none without a veto.
int applyVeto(DetectionSet& set, const Veto& veto);

}  // namespace map_matcher::scrubbing
