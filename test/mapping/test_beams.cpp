#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "map_matcher/mapping/beams.hpp"

namespace map_matcher::mapping {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Beams at 0 and 90 degrees of the laser.
scan::PlanarScan quarterScan(float ahead, float left) { return {0.0, M_PI_2, 0.1, 20.0, {ahead, left}}; }

BeamFan cast(const scan::PlanarScan& scan, const BeamLimits& limits = {}) { return castBeams(scan, {}, limits); }

TEST(Beams, EndWhereTheRangesPointInTheBaseFrame) {
  const scan::LaserMount mount{{0.25, 0.1, M_PI_2}, false};

  const BeamFan fan = castBeams(quarterScan(2.0F, 3.0F), mount, {});

  ASSERT_EQ(fan.beams.size(), 2U);
  EXPECT_TRUE(fan.origin.isApprox(Eigen::Vector2d(0.25, 0.1)));
  EXPECT_TRUE(fan.beams[0].end.isApprox(Eigen::Vector2d(0.25, 2.1), 1e-12));
  EXPECT_TRUE(fan.beams[1].end.isApprox(Eigen::Vector2d(0.25 - 3.0, 0.1), 1e-12));
}

TEST(Beams, OfALaserUpsideDownTurnTheOtherWay) {
  const BeamFan fan = castBeams(quarterScan(2.0F, 3.0F), {{0.0, 0.0, 0.0}, true}, {});

  ASSERT_EQ(fan.beams.size(), 2U);
  EXPECT_TRUE(fan.beams[0].end.isApprox(Eigen::Vector2d(2.0, 0.0), 1e-12));
  EXPECT_NEAR(fan.beams[1].end.y(), -3.0, 1e-12);
}

TEST(Beams, OfAClockwiseLaserTurnClockwise) {
  scan::PlanarScan scan = quarterScan(2.0F, 3.0F);
  scan.angle_increment = -M_PI_2;

  EXPECT_NEAR(cast(scan).beams[1].end.y(), -3.0, 1e-12);
}

TEST(Beams, OfInfAndNanSayNothing) { EXPECT_TRUE(cast(quarterScan(kInf, kNan)).beams.empty()); }

TEST(Beams, BeyondMaxRangeSayNothing) { EXPECT_EQ(cast(quarterScan(12.0F, 3.0F), {10.0, 0.0}).beams.size(), 1U); }

TEST(Beams, AtRangeMaxSayNothingByDefault) { EXPECT_EQ(cast(quarterScan(20.0F, 19.98F)).beams.size(), 1U); }

TEST(Beams, BetweenMaxUrangeAndMaxRangeClearUpToMaxUrange) {
  const BeamFan fan = cast(quarterScan(12.0F, 3.0F), {15.0, 10.0});

  ASSERT_EQ(fan.beams.size(), 2U);
  EXPECT_FALSE(fan.beams[0].hit);
  EXPECT_NEAR(fan.beams[0].end.x(), 10.0, 1e-12);
  EXPECT_TRUE(fan.beams[1].hit);
}

TEST(Beams, BelowRangeMinCountAsRangeMax) {
  for (const float range : {0.0F, -kInf, 0.05F}) {
    EXPECT_EQ(cast(quarterScan(range, 3.0F)).beams.size(), 1U) << range << " with the default limits says nothing";

    const BeamFan clearing = cast(quarterScan(range, 3.0F), {30.0, 10.0});
    ASSERT_EQ(clearing.beams.size(), 2U) << range;
    EXPECT_FALSE(clearing.beams[0].hit);
    EXPECT_NEAR(clearing.beams[0].end.x(), 10.0, 1e-12);
  }
}

TEST(Beams, KeepTheirHitsWhenTheFanIsMoved) {
  const BeamFan fan = transform({1.0, 2.0, M_PI}, cast(quarterScan(2.0F, 3.0F)));

  EXPECT_TRUE(fan.origin.isApprox(Eigen::Vector2d(1.0, 2.0)));
  EXPECT_TRUE(fan.beams[0].end.isApprox(Eigen::Vector2d(-1.0, 2.0), 1e-12));
  EXPECT_EQ(countHits(fan), 2);
}

TEST(PlanarScan, ThatIsNotValidNamesTheFieldAndItsValue) {
  const auto messageFor = [](const scan::PlanarScan& scan) -> std::string {
    try {
      scan.validate();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_EQ(messageFor({0.0, 0.1, 0.0, 1.0, {1.0F}}), "no error");
  EXPECT_NE(messageFor({nan, 0.1, 0.0, 1.0, {1.0F}}).find("angle_min is nan"), std::string::npos);
  EXPECT_NE(messageFor({0.0, 0.0, 0.0, 1.0, {1.0F}}).find("angle_increment is 0"), std::string::npos);
  EXPECT_NE(messageFor({1e30, 0.1, 0.0, 1.0, {1.0F}}).find("angle_min is 1e+30"), std::string::npos);
  for (const double increment : {nan, 1e8, -1e8, 1e-9, 1e-310}) {
    EXPECT_NE(messageFor({0.0, increment, 0.0, 1.0, {1.0F}}).find("angle_increment is "), std::string::npos);
  }
  EXPECT_NE(messageFor({0.0, 0.1, 0.0, 1e30, {1.0F}}).find("range_max is 1e+30"), std::string::npos);
  EXPECT_NE(messageFor({0.0, 0.1, -1.0, 1.0, {1.0F}}).find("range_min is -1"), std::string::npos);
  EXPECT_NE(messageFor({0.0, 0.1, 2.0, 1.0, {1.0F}}).find("range_max is 1"), std::string::npos);
  EXPECT_NE(messageFor({0.0, 0.1, 0.0, 1.0, {}}).find("0 ranges"), std::string::npos);
}

}  // namespace
}  // namespace map_matcher::mapping
