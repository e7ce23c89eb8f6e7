#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "map_matcher/scrubbing/detector_watch.hpp"

namespace map_matcher::scrubbing {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Watch : public testing::Test {
 protected:
  Watch() { watch.restart(fromSeconds(100.0)); }

  /// Detections made from a scan of this stamp come.
  void hear(const std::string& topic, double stamp, double now) {
    watch.onDetections({topic, "laser", fromSeconds(stamp), {}}, fromSeconds(now));
  }

  void scan(double now) { watch.onScan(fromSeconds(now), fromSeconds(now)); }

  /// Ten scans a second, each of whose detections come after `delay` [s].
  void drive(double from, double to, double delay) {
    for (double time = from; time < to; time += 0.1) {
      for (const char* topic : {"front", "rear"}) {
        hear(topic, time - delay, time);
      }
      scan(time);
    }
  }

  DetectorHealth healthAt(double time) { return watch.health(watch.record("front"), fromSeconds(time)); }
  std::vector<std::string> uselessAt(double time) { return watch.uselessTopics(fromSeconds(time)); }

  DetectorWatch watch{{"front", "rear"}, {1.0, 5.0, 0.25}};
};

TEST_F(Watch, FindsADetectorSilentThatWasNeverHeard) {
  EXPECT_EQ(healthAt(100.5), DetectorHealth::kAlive);
  EXPECT_EQ(healthAt(101.5), DetectorHealth::kQuiet);
  EXPECT_EQ(healthAt(105.5), DetectorHealth::kSilent);
}

TEST_F(Watch, CountsSilenceFromTheLastMessage) {
  hear("front", 103.95, 104.0);

  EXPECT_EQ(healthAt(104.9), DetectorHealth::kAlive);
  EXPECT_NEAR(watch.silence(watch.record("front"), fromSeconds(104.9)), 0.9, 1e-9);
}

TEST_F(Watch, FindsADetectorUselessUntilItServedAScan) {
  hear("front", 100.0, 100.1);
  hear("rear", 100.0, 100.1);
  EXPECT_THAT(uselessAt(100.1), ElementsAre("front", "rear"));

  scan(100.2);

  EXPECT_THAT(uselessAt(100.2), IsEmpty());
}

TEST_F(Watch, FindsADetectorUselessThatIsSilent) {
  drive(100.0, 104.0, 0.1);
  EXPECT_THAT(uselessAt(104.0), IsEmpty());

  hear("front", 109.0, 109.1);
  scan(109.2);

  EXPECT_THAT(uselessAt(109.2), ElementsAre("rear"));
}

TEST_F(Watch, BeginsAnewWhenTimeDoes) {
  drive(100.0, 104.0, 0.1);
  watch.restart(fromSeconds(50.0));

  EXPECT_EQ(healthAt(50.5), DetectorHealth::kAlive);
  EXPECT_EQ(healthAt(56.0), DetectorHealth::kSilent);
  EXPECT_THAT(uselessAt(50.5), ElementsAre("front", "rear"));
}

TEST_F(Watch, IsNotSilentWhileTimeIsZero) {
  watch.restart(Stamp(0));

  EXPECT_EQ(healthAt(0.0), DetectorHealth::kAlive);
}

TEST_F(Watch, TellsADetectorThatIsTooLateForEveryScan) {
  drive(100.0, 104.0, 0.2);
  EXPECT_EQ(healthAt(104.0), DetectorHealth::kAlive);

  drive(104.0, 108.0, 0.35);
  EXPECT_EQ(healthAt(108.0), DetectorHealth::kTooLate);
  EXPECT_THAT(uselessAt(108.0), IsEmpty());  // not for long enough

  drive(108.0, 110.0, 0.35);
  EXPECT_THAT(uselessAt(110.0), ElementsAre("front", "rear"));

  drive(110.0, 110.2, 0.2);
  EXPECT_EQ(healthAt(110.2), DetectorHealth::kAlive);
  EXPECT_THAT(uselessAt(110.2), IsEmpty());
}

TEST_F(Watch, TakesADetectorThatServesNowAndThenForAlive) {
  for (int i = 0; i < 60; ++i) {  // each message serves the first of three scans
    const double time = 100.0 + 0.3 * i;
    hear("front", time - 0.2, time);
    scan(time + 0.01);
    scan(time + 0.11);
    scan(time + 0.21);
  }

  EXPECT_EQ(healthAt(118.0), DetectorHealth::kAlive);
}

TEST_F(Watch, DoesNotBlameADetectorForScansThatCameLongAfterItsLastMessage) {
  hear("front", 100.0, 100.1);
  scan(100.1);
  scan(109.0);
  hear("front", 108.9, 109.1);

  EXPECT_EQ(healthAt(109.2), DetectorHealth::kAlive);
}

}  // namespace
}  // namespace map_matcher::scrubbing
