#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_messages.hpp"
#include "map_matcher/ros/people_removal.hpp"

namespace map_matcher {
namespace {

constexpr int kBeams = 90;
constexpr float kInf = std::numeric_limits<float>::infinity();

boost::shared_ptr<sensor_msgs::LaserScan> scanAt(double stamp, const std::string& frame = "laser") {
  auto scan = boost::make_shared<sensor_msgs::LaserScan>();
  scan->header.frame_id = frame;
  scan->header.stamp = ros::Time(stamp);
  scan->header.seq = 7;
  scan->angle_increment = static_cast<float>(2.0 * M_PI / kBeams);
  scan->angle_max = scan->angle_increment * (kBeams - 1);
  scan->range_max = 20.0F;
  scan->ranges.assign(kBeams, 3.0F);
  scan->ranges[5] = std::numeric_limits<float>::quiet_NaN();
  scan->ranges[6] = kInf;
  scan->intensities.assign(kBeams, 0.5F);
  return scan;
}

DetectionSet personAt(double stamp, double x, double y) {
  return {"detector", "laser", stampOf(ros::Time(stamp)), {{{x, y, 0.0}, 1.0}}};
}

class Removal : public testing::Test {
 protected:
  tf2::BufferCore tf;
  ScrubbingOptions options;
  PeopleRemoval removal{tf, "odom", options};
};

TEST_F(Removal, HandsOnTheVeryMessageOfAScanWithoutPeople) {
  const auto scan = scanAt(10.0);
  removal.add(personAt(10.0, 8.0, 0.0));
  removal.onScan(*scan);

  const ScrubbedScan scrubbed = removal.scrub(scan);

  EXPECT_EQ(scrubbed.scan, scan);
  EXPECT_TRUE(scrubbed.removed.empty());
  EXPECT_EQ(scrubbed.points, kBeams - 2);
}

TEST_F(Removal, ChangesTheRangesNearPeopleAndNotABitElse) {
  const auto scan = scanAt(10.0);
  const sensor_msgs::LaserScan before = *scan;
  removal.add(personAt(10.0, 3.0, 0.0));
  removal.onScan(*scan);

  const ScrubbedScan scrubbed = removal.scrub(scan);

  ASSERT_EQ(scrubbed.removed, (std::vector<std::uint32_t>{0, 1, kBeams - 1}));
  EXPECT_EQ(std::memcmp(scan->ranges.data(), before.ranges.data(), kBeams * sizeof(float)), 0);  // not mutated
  sensor_msgs::LaserScan restored = *scrubbed.scan;
  for (const std::uint32_t beam : scrubbed.removed) {
    EXPECT_EQ(restored.ranges[beam], kInf);
    restored.ranges[beam] = before.ranges[beam];
  }
  EXPECT_EQ(std::memcmp(restored.ranges.data(), before.ranges.data(), kBeams * sizeof(float)), 0);
  EXPECT_EQ(restored.header, before.header);
  EXPECT_EQ(restored.intensities, before.intensities);
}

TEST_F(Removal, LeavesAScanAsItIsThatWouldLoseTooMuch) {
  const auto scan = scanAt(10.0);
  for (int i = 0; i < 63; ++i) {
    removal.add(personAt(10.0, 3.0 * std::cos(0.1 * i), 3.0 * std::sin(0.1 * i)));
  }
  removal.onScan(*scan);

  const ScrubbedScan scrubbed = removal.scrub(scan);

  EXPECT_TRUE(scrubbed.tooMany());
  EXPECT_EQ(scrubbed.scan, scan);
  EXPECT_EQ(scrubbed.near_people, static_cast<std::size_t>(kBeams - 2));
}

TEST_F(Removal, ForgetsWhenTimeGoesBackOrTheLaserIsAnother) {
  EXPECT_FALSE(removal.onScan(*scanAt(10.0)));
  EXPECT_FALSE(removal.onScan(*scanAt(9.9)));  // a scan that came late
  removal.add(personAt(9.0, 3.0, 0.0));

  const auto went_back = removal.onScan(*scanAt(9.0));
  ASSERT_TRUE(went_back);
  EXPECT_NE(went_back->find("went back by 1.0"), std::string::npos) << *went_back;
  EXPECT_TRUE(removal.scrub(scanAt(9.0)).removed.empty());

  removal.add(personAt(9.1, 3.0, 0.0));
  const auto other_laser = removal.onScan(*scanAt(9.1, "rear_laser"));
  ASSERT_TRUE(other_laser);
  EXPECT_NE(other_laser->find("is now rear_laser instead of laser"), std::string::npos) << *other_laser;
}

TEST_F(Removal, RefusesScansThatMakeNoSenseAndStaysAsItWas) {
  removal.onScan(*scanAt(10.0));
  auto bad = scanAt(5.0);
  bad->ranges.clear();

  EXPECT_THROW(removal.onScan(*bad), MessageError);
  EXPECT_EQ(removal.newestScan(), stampOf(ros::Time(10.0)));
}

}  // namespace
}  // namespace map_matcher
