#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>

#include "map_matcher/scrubbing/scan_scrubber.hpp"

namespace map_matcher::scrubbing {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Four beams: ahead, to the left, behind, to the right.
constexpr double kQuarter = M_PI_2;
const scan::ScanLayout kFourBeams{0.0, kQuarter, 0.05, 20.0};

/// What beamsInside() is to find: every measured point against every disc.
std::vector<std::uint32_t> everyPointAgainstEveryDisc(const scan::ScanLayout& layout, const std::vector<float>& ranges,
                                                      const std::vector<Disc>& discs) {
  std::vector<std::uint32_t> beams;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const auto range = static_cast<double>(ranges[i]);
    const double angle = layout.angle_min + static_cast<double>(i) * layout.angle_increment;
    const Eigen::Vector2d point(range * std::cos(angle), range * std::sin(angle));
    bool inside = false;
    for (const Disc& disc : discs) {
      inside = inside || (point - disc.centre).squaredNorm() <= disc.radius * disc.radius;
    }
    if (inside && range >= layout.range_min && range <= layout.range_max) {
      beams.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return beams;
}

TEST(ScanScrubber, FindsThePointsWithinADisc) {
  ScanScrubber scrubber;
  const std::vector<float> ranges{2.0F, 2.0F, 2.0F, 2.0F};

  EXPECT_THAT(scrubber.beamsInside(kFourBeams, ranges, {{{2.2, 0.0}, 0.3}}), ElementsAre(0U));
  EXPECT_THAT(scrubber.beamsInside(kFourBeams, ranges, {{{2.4, 0.0}, 0.3}}), IsEmpty());
  EXPECT_THAT(scrubber.beamsInside(kFourBeams, ranges, {{{-2.0, 0.1}, 0.3}, {{0.1, -1.8}, 0.3}}), ElementsAre(2U, 3U));
}

TEST(ScanScrubber, CountsTheBorderOfADiscAsInside) {
  ScanScrubber scrubber;

  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {2.0F, 2.0F, 2.0F, 2.0F}, {{{2.5, 0.0}, 0.5}}), ElementsAre(0U));
}

TEST(ScanScrubber, LeavesWhatIsInFrontOfAPersonAndBehind) {
  ScanScrubber scrubber;
  const Disc person{{3.0, 0.0}, 0.3};

  for (const float range : {1.0F, 2.6F, 3.4F, 8.0F}) {
    EXPECT_THAT(scrubber.beamsInside(kFourBeams, {range, 9.0F, 9.0F, 9.0F}, {person}), IsEmpty()) << range;
  }
}

TEST(ScanScrubber, FindsEverythingNearALaserThatAPersonStandsOn) {
  ScanScrubber scrubber;

  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {0.1F, 0.2F, 0.5F, 0.1F}, {{{0.0, 0.1}, 0.3}}), ElementsAre(0U, 1U, 3U));
}

TEST(ScanScrubber, KnowsNoPointWhereNothingWasMeasured) {
  ScanScrubber scrubber;
  const Disc everywhere{{0.0, 0.0}, 1000.0};

  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {kInf, kNan, -kInf, 0.0F}, {everywhere}), IsEmpty());
  EXPECT_EQ(scrubber.numPoints(), 0);
  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {0.04F, 20.5F, 0.06F, 19.5F}, {everywhere}), ElementsAre(2U, 3U));
  EXPECT_EQ(scrubber.numPoints(), 2);
}

TEST(ScanScrubber, IgnoresDiscsThatAreNoNumbers) {
  ScanScrubber scrubber;
  const auto nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {2.0F, 2.0F, 2.0F, 2.0F}, {{{nan, 0.0}, 0.3}, {{2.0, nan}, 0.3}}),
              IsEmpty());
}

TEST(ScanScrubber, TakesScansOfAnyNumberOfBeamsInTurn) {
  ScanScrubber scrubber;
  const Disc person{{2.0, 0.0}, 0.3};

  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {2.0F, 2.0F, 2.0F, 2.0F}, {person}), ElementsAre(0U));
  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {2.0F}, {person}), ElementsAre(0U));
  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {}, {person}), IsEmpty());
  EXPECT_THAT(scrubber.beamsInside(kFourBeams, {2.0F, 2.0F, 2.0F, 2.0F, 2.0F}, {person}), ElementsAre(0U, 4U));
}

/// Scans of many kinds with discs anywhere, from a seed.
class AnyScan : public testing::TestWithParam<unsigned> {
 protected:
  AnyScan() {
    layout.angle_min = uniform(-8.0, 8.0);
    layout.angle_increment = (random() % 2 == 0 ? 1.0 : -1.0) * uniform(0.002, 0.2);
    layout.range_min = 0.05;
    layout.range_max = uniform(1.0, 20.0);
    for (std::size_t beams = 1 + random() % 1500; ranges.size() < beams;) {
      const double kind = uniform(0.0, 1.0);
      const double range = uniform(0.0, layout.range_max + 1.0);
      ranges.push_back(kind < 0.05 ? kInf : kind < 0.1 ? kNan : static_cast<float>(range));
    }
    for (std::size_t num_discs = random() % 40; discs.size() < num_discs;) {
      discs.push_back({{uniform(-12.0, 12.0), uniform(-12.0, 12.0)}, uniform(0.05, 1.0)});
    }
  }

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  }

  std::mt19937 random{GetParam()};
  scan::ScanLayout layout;
  std::vector<float> ranges;
  std::vector<Disc> discs;
  ScanScrubber scrubber;
};

TEST_P(AnyScan, LosesExactlyThePointsInTheDiscs) {
  EXPECT_EQ(scrubber.beamsInside(layout, ranges, discs), everyPointAgainstEveryDisc(layout, ranges, discs));
}

TEST_P(AnyScan, LosesNothingMoreWhenScrubbedAgain) {
  for (const std::uint32_t beam : scrubber.beamsInside(layout, ranges, discs)) {
    ranges[beam] = kInf;
  }

  EXPECT_THAT(scrubber.beamsInside(layout, ranges, discs), IsEmpty());
}

/// Numbers that a broken driver may write into a field of a scan, and some that are right.
const double kAbsurd[] = {std::numeric_limits<double>::quiet_NaN(),
                          HUGE_VAL,
                          -HUGE_VAL,
                          0.0,
                          1e-310,
                          -1e-310,
                          1e-30,
                          1e8,
                          -1e8,
                          1e30,
                          -1e30,
                          3e38,
                          M_PI,
                          -M_PI,
                          0.01,
                          -0.01,
                          1e-6,
                          20.0};

/// Scans whose every field is absurd or not, from a seed.
class AbsurdScan : public AnyScan {
 protected:
  AbsurdScan() {
    for (double* field : {&layout.angle_min, &layout.angle_increment, &layout.range_min, &layout.range_max}) {
      if (random() % 3 == 0) {
        *field = kAbsurd[random() % std::size(kAbsurd)];
      }
    }
    const std::size_t numbers_of_beams[] = {0, 1, ranges.size(), 100000};
    ranges.resize(numbers_of_beams[random() % 4], 2.0F);
    for (std::size_t i = 0; i < ranges.size(); i += 1 + random() % 50) {
      ranges[i] = static_cast<float>(kAbsurd[random() % std::size(kAbsurd)]);
    }
    discs.push_back({{kAbsurd[random() % std::size(kAbsurd)], 1.0}, 0.3});
  }

  bool isValid() const {
    try {
      layout.validate();
      return true;
    } catch (const std::invalid_argument&) {
      return false;
    }
  }
};

TEST_P(AbsurdScan, LosesExactlyThePointsInTheDiscsWhenItIsValidAndEndsWhenItIsNot) {
  const std::vector<std::uint32_t> beams = scrubber.beamsInside(layout, ranges, discs);

  if (isValid()) {
    EXPECT_EQ(beams, everyPointAgainstEveryDisc(layout, ranges, discs));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AbsurdScan, testing::Range(1000U, 1300U));

INSTANTIATE_TEST_SUITE_P(Seeds, AnyScan, testing::Range(0U, 300U));

}  // namespace
}  // namespace map_matcher::scrubbing
