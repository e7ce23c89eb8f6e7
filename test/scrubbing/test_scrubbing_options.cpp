#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "map_matcher/scrubbing/scan_scrubber.hpp"
#include "map_matcher/scrubbing/scrubbing_options.hpp"

namespace map_matcher::scrubbing {
namespace {

const scan::ScanLayout kLayout{0.0, 0.1, 0.05, 20.0};

TEST(RemovedRange, IsWhatWasChosen) {
  EXPECT_TRUE(std::isinf(removedRange("inf", kLayout)));
  EXPECT_GT(removedRange("inf", kLayout), 0.0F);
  EXPECT_TRUE(std::isnan(removedRange("nan", kLayout)));
  EXPECT_EQ(removedRange("over_range", kLayout), 21.0F);
}

TEST(RemovedRange, RefusesAnotherChoice) { EXPECT_THROW(removedRange("zero", kLayout), std::invalid_argument); }

TEST(RemovedRange, IsNeverAPoint) {
  ScanScrubber scrubber;
  for (const char* choice : {"inf", "nan", "over_range"}) {
    scrubber.beamsInside(kLayout, {removedRange(choice, kLayout)}, {});
    EXPECT_EQ(scrubber.numPoints(), 0) << choice;
  }
}

}  // namespace
}  // namespace map_matcher::scrubbing
