#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "map_matcher/scan/scan_sets.hpp"

namespace map_matcher::scan {
namespace {

using Sets = ScanSets<std::string>;

/// "front0,rear0@1.00", "front0,-@1.00"; "none" when there is no set.
std::string text(const std::optional<Sets::Set>& set) {
  if (!set) {
    return "none";
  }
  std::string names;
  for (const auto& scan : set->scans) {
    names += (names.empty() ? "" : ",") + scan.value_or("-");
  }
  return names;
}

class ScanSetsOfTwo : public testing::Test {
 protected:
  void front(double stamp, const std::string& name) { sets.add(0, stamp, name); }
  void rear(double stamp, const std::string& name) { sets.add(1, stamp, name); }

  Sets sets{2, {0.1, 0.1, 1.0}};
};

TEST_F(ScanSetsOfTwo, AreCompleteWhenTheOtherLaserCannotBeNearerAnyMore) {
  rear(0.97, "r0");
  front(1.0, "f0");
  EXPECT_EQ(text(sets.next(1.0)), "none") << "a nearer one may come";

  rear(1.02, "r1");
  EXPECT_EQ(text(sets.next(1.02)), "f0,r1");
  EXPECT_EQ(text(sets.next(1.02)), "none") << "each scan leads once";
}

TEST_F(ScanSetsOfTwo, TakeTheScanThatIsNearestInTime) {
  rear(0.99, "r0");
  front(1.0, "f0");
  rear(1.05, "r1");

  EXPECT_EQ(text(sets.next(1.05)), "f0,r0");
}

TEST_F(ScanSetsOfTwo, AreNotWaitedForLongerThanPatienceLasts) {
  rear(0.97, "r0");
  front(1.0, "f0");

  EXPECT_EQ(text(sets.next(1.09)), "none");
  EXPECT_EQ(text(sets.next(1.11)), "f0,r0");
}

TEST_F(ScanSetsOfTwo, LeaveOutScansThatAreTooFarApart) {
  front(1.0, "f0");
  rear(1.11, "r0");

  EXPECT_EQ(text(sets.next(1.11)), "f0,-");
}

TEST_F(ScanSetsOfTwo, DoNotWaitForALaserThatIsSilent) {
  rear(1.0, "r0");
  front(1.0, "f0");
  EXPECT_EQ(text(sets.next(1.0)), "f0,r0");

  front(2.1, "f1");
  EXPECT_EQ(text(sets.next(2.1)), "f1,-");
}

TEST_F(ScanSetsOfTwo, GoOnWithTheOtherLaserWhileTheLeadingOneIsSilent) {
  front(1.0, "f0");
  rear(1.0, "r0");
  EXPECT_EQ(text(sets.next(1.0)), "f0,r0");

  rear(2.05, "r1");
  EXPECT_EQ(text(sets.next(2.05)), "-,r1");

  front(2.1, "f1");
  rear(2.1, "r2");
  EXPECT_EQ(text(sets.next(2.1)), "f1,r2");
}

TEST_F(ScanSetsOfTwo, ComeInTheOrderOfTheirStampsWhenManyWait) {
  for (const double stamp : {1.0, 1.07, 1.14}) {
    front(stamp, "f" + std::to_string(stamp).substr(0, 4));
    rear(stamp, "r" + std::to_string(stamp).substr(0, 4));
  }

  EXPECT_EQ(text(sets.next(1.14)), "f1.00,r1.00");
  EXPECT_EQ(text(sets.next(1.14)), "f1.07,r1.07");
  EXPECT_EQ(text(sets.next(1.14)), "f1.14,r1.14");
  EXPECT_EQ(text(sets.next(1.14)), "none");
}

TEST_F(ScanSetsOfTwo, BeginAnewWhenTimeGoesBack) {
  front(100.0, "f0");
  rear(100.0, "r0");
  EXPECT_EQ(text(sets.next(100.0)), "f0,r0");

  EXPECT_TRUE(sets.add(0, 1.0, "f1"));
  EXPECT_FALSE(sets.add(1, 1.0, "r1"));
  EXPECT_EQ(text(sets.next(1.0)), "f1,r1");
}

TEST_F(ScanSetsOfTwo, LeaveOutAScanThatIsOutOfOrder) {
  front(1.0, "f0");
  EXPECT_FALSE(sets.add(0, 0.95, "late"));
  EXPECT_FALSE(sets.add(0, 1.0, "twice"));
  rear(1.0, "r0");

  EXPECT_EQ(text(sets.next(1.0)), "f0,r0");
  EXPECT_EQ(text(sets.next(1.0)), "none");
}

}  // namespace
}  // namespace map_matcher::scan
