#include "map_matcher/scrubbing/detections.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace map_matcher::scrubbing {
namespace {

constexpr double kMaxDistance = 1e4;  // [m] no laser sees farther

bool isUsable(const Detection& detection) {
  return std::isfinite(detection.score) && detection.position.allFinite() &&
         detection.position.cwiseAbs().maxCoeff() <= kMaxDistance;
}

template <typename Condition>
int removeUnless(std::vector<Detection>& detections, const Condition& keep) {
  const auto end = std::partition(detections.begin(), detections.end(), keep);
  const auto num_removed = static_cast<int>(std::distance(end, detections.end()));
  detections.erase(end, detections.end());
  return num_removed;
}

}  // namespace

LeftOut applyLimits(DetectionSet& set, const DetectionLimits& limits) {
  std::vector<Detection>& detections = set.detections;
  LeftOut left_out;
  left_out.not_finite = removeUnless(detections, isUsable);
  left_out.low_score =
      removeUnless(detections, [&limits](const Detection& d) { return d.score >= limits.score_threshold; });
  const auto max_detections = static_cast<std::size_t>(limits.max_detections);
  if (detections.size() > max_detections) {
    left_out.too_many = static_cast<int>(detections.size() - max_detections);
    std::nth_element(
        detections.begin(), detections.begin() + limits.max_detections, detections.end(),
        [](const Detection& a, const Detection& b) { return a.position.squaredNorm() < b.position.squaredNorm(); });
    detections.resize(max_detections);
  }
  return left_out;
}

int applyVeto(DetectionSet& set, const Veto& veto) {
  return veto ? removeUnless(set.detections, [&veto](const Detection& detection) { return !veto(detection); }) : 0;
}

}  // namespace map_matcher::scrubbing
