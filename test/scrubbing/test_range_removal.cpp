#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "map_matcher/scrubbing/range_removal.hpp"

namespace map_matcher::scrubbing {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr float kInf = std::numeric_limits<float>::infinity();

/// Ahead, to the left, behind, to the right.
const scan::ScanLayout kFourBeams{0.0, M_PI_2, 0.05, 20.0};

class RangesNearPeople : public testing::Test {
 protected:
  RangeRemoval remove(const std::vector<Disc>& discs) {
    return removeRanges(kFourBeams, ranges, discs, options, scrubber);
  }

  std::vector<float> ranges{2.0F, 3.0F, kInf, 4.0F};
  ScrubbingOptions options;
  ScanScrubber scrubber;
};

TEST_F(RangesNearPeople, AreWrittenOverAndNoOthers) {
  const RangeRemoval removal = remove({{{2.1, 0.0}, 0.3}});

  EXPECT_THAT(removal.ranges, ElementsAre(kInf, 3.0F, kInf, 4.0F));
  EXPECT_THAT(removal.removed, ElementsAre(0U));
  EXPECT_EQ(removal.near_people, 1U);
  EXPECT_EQ(removal.points, 3);
}

TEST_F(RangesNearPeople, BecomeWhatWasChosen) {
  options.removed_range = "over_range";

  EXPECT_THAT(remove({{{2.1, 0.0}, 0.3}}).ranges, ElementsAre(21.0F, 3.0F, kInf, 4.0F));
}

TEST_F(RangesNearPeople, StayWhenTooManyWouldGo) {
  options.max_removed_fraction = 0.5;

  const RangeRemoval removal = remove({{{2.1, 0.0}, 0.3}, {{0.0, 3.0}, 0.3}});

  EXPECT_EQ(removal.ranges, ranges);
  EXPECT_THAT(removal.removed, IsEmpty());
  EXPECT_EQ(removal.near_people, 2U);
}

TEST_F(RangesNearPeople, AreNoneWhereNobodyIs) {
  const RangeRemoval removal = remove({});

  EXPECT_EQ(removal.ranges, ranges);
  EXPECT_THAT(removal.removed, IsEmpty());
}

TEST_F(RangesNearPeople, AreNoneInAScanThatMeasuredNothing) {
  ranges.assign(4, kInf);

  EXPECT_THAT(remove({{{2.1, 0.0}, 0.3}}).removed, IsEmpty());
}

}  // namespace
}  // namespace map_matcher::scrubbing
