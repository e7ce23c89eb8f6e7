#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher::scrubbing {
namespace {

DetectionSet setOf(std::vector<Detection> detections) { return {"detector", "laser", Stamp(0), std::move(detections)}; }

TEST(DetectionLimits, KeepScoresFromTheThresholdOn) {
  DetectionSet set = setOf({{{1.0, 0.0, 0.0}, 0.39}, {{2.0, 0.0, 0.0}, 0.4}, {{3.0, 0.0, 0.0}, 0.9}});

  const LeftOut left_out = applyLimits(set, {});

  EXPECT_EQ(left_out.low_score, 1);
  ASSERT_EQ(set.detections.size(), 2U);
  for (const Detection& detection : set.detections) {
    EXPECT_GE(detection.score, 0.4);
  }
}

TEST(DetectionLimits, LeaveOutWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  DetectionSet set =
      setOf({{{nan, 0.0, 0.0}}, {{0.0, inf, 0.0}}, {{1e30, 0.0, 0.0}}, {{0.0, 0.0, 0.0}, nan}, {{1.0, 2.0, 0.0}}});

  const LeftOut left_out = applyLimits(set, {});

  EXPECT_EQ(left_out.not_finite, 4);
  ASSERT_EQ(set.detections.size(), 1U);
  EXPECT_EQ(set.detections[0].position, Eigen::Vector3d(1.0, 2.0, 0.0));
}

TEST(DetectionLimits, KeepTheNearestOfTooMany) {
  std::vector<Detection> many;
  for (int i = 10000; i > 0; --i) {
    many.push_back({{0.001 * i, 0.0, 0.0}});
  }
  DetectionSet set = setOf(many);
  DetectionLimits limits;
  limits.max_detections = 3;

  const LeftOut left_out = applyLimits(set, limits);

  EXPECT_EQ(left_out.too_many, 9997);
  EXPECT_EQ(left_out.total(), 9997);
  ASSERT_EQ(set.detections.size(), 3U);
  for (const Detection& detection : set.detections) {
    EXPECT_LE(detection.position.x(), 0.0031);
  }
}

}  // namespace
}  // namespace map_matcher::scrubbing
