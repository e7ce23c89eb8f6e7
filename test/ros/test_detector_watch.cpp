#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "map_matcher/ros/detector_watch.hpp"

namespace map_matcher {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Watch : public testing::Test {
 protected:
  Watch() { watch.restart(ros::Time(100.0)); }

  DetectorHealth healthAt(double time) { return watch.health(watch.record("front"), ros::Time(time)); }

  DetectorWatch watch{{"front", "rear"}, 1.0, 5.0, 0.25};
};

TEST_F(Watch, FindsADetectorSilentThatWasNeverHeard) {
  EXPECT_EQ(healthAt(100.5), DetectorHealth::kAlive);
  EXPECT_EQ(healthAt(101.5), DetectorHealth::kQuiet);
  EXPECT_EQ(healthAt(105.5), DetectorHealth::kSilent);
  EXPECT_FALSE(watch.allHeard());
}

TEST_F(Watch, CountsSilenceFromTheLastMessage) {
  watch.record("front").last_heard = ros::Time(104.0);

  EXPECT_EQ(healthAt(104.9), DetectorHealth::kAlive);
  EXPECT_NEAR(watch.silence(watch.record("front"), ros::Time(104.9)), 0.9, 1e-9);
  EXPECT_THAT(watch.silentTopics(ros::Time(106.0)), ElementsAre("rear"));
}

TEST_F(Watch, BeginsAnewWhenTimeDoes) {
  watch.record("front").last_heard = ros::Time(104.0);
  watch.restart(ros::Time(50.0));

  EXPECT_EQ(healthAt(50.5), DetectorHealth::kAlive);
  EXPECT_EQ(healthAt(56.0), DetectorHealth::kSilent);
}

TEST_F(Watch, IsNotSilentWhileTimeIsZero) {
  watch.restart(ros::Time());

  EXPECT_THAT(watch.silentTopics(ros::Time()), IsEmpty());
}

TEST_F(Watch, TellsADetectorThatIsTooLateForTheCache) {
  DetectorRecord& record = watch.record("front");
  record.last_heard = ros::Time(104.0);
  record.last_delay = 0.35;

  EXPECT_EQ(healthAt(104.1), DetectorHealth::kTooLate);
  record.last_delay = 0.05;
  EXPECT_EQ(healthAt(104.1), DetectorHealth::kAlive);
}

}  // namespace
}  // namespace map_matcher
