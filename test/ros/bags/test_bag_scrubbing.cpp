#include <geometry_msgs/PoseArray.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/String.h>

#include <cmath>

#include "map_matcher/ros/bags/bag_scrubbing.hpp"
#include "support/bags.hpp"
#include "support/data_dir.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_bags {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kBeams = 360;
constexpr int kScans = 20;
constexpr double kPeriod = 0.07;     // [s] between two scans
constexpr double kLatency = 0.02;    // [s] from a scan to its detections
constexpr float kRange = 4.0F;       // [m] of every beam
constexpr int kBeamsNearPerson = 9;  // of a person 4 m away, within 2 asin(0.15 / 4) = 4.3 degrees on either side

ros::Time stampOfScan(int i) { return ros::Time(1000.0 + kPeriod * i); }

/// Writes a bag of a laser in the middle of a round room. Every second scan, from the first on, somebody stands at the
/// wall ahead and is detected.
class BagScrubbing : public testing::Test {
 protected:
  BagScrubbing() {
    rosbag::Bag bag(request.bag, rosbag::bagmode::Write);
    for (int i = 0; i < kScans; ++i) {
      sensor_msgs::LaserScan scan;
      scan.header.stamp = stampOfScan(i);
      scan.header.frame_id = "laser";
      scan.angle_increment = static_cast<float>(2.0 * M_PI / kBeams);
      scan.angle_min = static_cast<float>(-M_PI);
      scan.angle_max = scan.angle_min + scan.angle_increment * (kBeams - 1);
      scan.range_max = 20.0F;
      scan.ranges.assign(kBeams, kRange);
      geometry_msgs::PoseArray people;
      people.header = scan.header;
      if (i % 2 == 0) {
        people.poses.resize(1);
        people.poses[0].position.x = static_cast<double>(kRange);
      }
      bag.write("/scan", scan.header.stamp, scan);
      bag.write("/people", scan.header.stamp, people);
      bag.write("/detections", scan.header.stamp + ros::Duration(kLatency), people);
      bag.write("/words", scan.header.stamp, std_msgs::String());
    }
    request.options.detection_topics = {"detections"};
    request.people_topic = "people";
  }

  test::TemporaryDir dir;
  BagScrubbingRequest request = [this] {
    BagScrubbingRequest made;
    made.bag = dir / "raw.bag";
    return made;
  }();
};

TEST_F(BagScrubbing, LosesEveryPointNearAPersonWhenItWaitsForTheDetections) {
  request.options.mode = "synchronised";
  request.options.scrubbing.cache.cache_duration = 0.0;

  const BagScrubbingResult result = scrubBag(request);

  EXPECT_EQ(result.scan_topic, "/scan");
  EXPECT_EQ(result.scans, kScans);
  EXPECT_EQ(result.scans_changed, kScans / 2);
  EXPECT_EQ(result.scans_timed_out, 0);
  EXPECT_EQ(result.detections, kScans / 2);
  EXPECT_EQ(result.points, kScans * kBeams);
  EXPECT_EQ(result.removed, kScans / 2 * kBeamsNearPerson);
  EXPECT_EQ(result.people.scans, kScans / 2);
  EXPECT_EQ(result.people.people, kScans / 2);
  EXPECT_EQ(result.people.near, kScans / 2 * kBeamsNearPerson);
  EXPECT_EQ(result.people.near_left, 0);
  EXPECT_EQ(result.people.others, kScans / 2 * (kBeams - kBeamsNearPerson));
  EXPECT_EQ(result.people.others_lost, 0);
}

TEST_F(BagScrubbing, AppliesDetectionsToTheNextScansWhenItDoesNotWait) {
  const BagScrubbingResult result = scrubBag(request);

  EXPECT_EQ(result.scans_changed, kScans - 1);  // the first one comes before any detection
  EXPECT_EQ(result.people.near_left, kBeamsNearPerson);
}

TEST_F(BagScrubbing, WritesEverythingAndTheScrubbedScans) {
  request.output = dir / "scrubbed.bag";

  scrubBag(request);

  const rosbag::Bag bag(request.output, rosbag::bagmode::Read);
  EXPECT_EQ(rosbag::View(bag, rosbag::TopicQuery("/words")).size(), static_cast<std::uint32_t>(kScans));
  EXPECT_EQ(rosbag::View(bag, rosbag::TopicQuery("/scan")).size(), static_cast<std::uint32_t>(kScans));
  rosbag::View view(bag, rosbag::TopicQuery("/scan_scrubbed"));
  EXPECT_EQ(view.size(), static_cast<std::uint32_t>(kScans));
  int i = 0;
  for (const rosbag::MessageInstance& message : view) {
    const auto scan = message.instantiate<sensor_msgs::LaserScan>();
    EXPECT_EQ(scan->header.stamp, stampOfScan(i));
    EXPECT_EQ(std::isinf(scan->ranges[kBeams / 2]), i > 0) << i;
    EXPECT_EQ(scan->ranges[0], kRange);
    ++i;
  }
}

TEST_F(BagScrubbing, NamesATopicThatIsNotThereAndThoseThatAre) {
  request.options.detection_topics = {"dr_spaam_detections"};

  EXPECT_THAT(test::thrownText<BagError>([&] { scrubBag(request); }),
              AllOf(HasSubstr("has no topic 'dr_spaam_detections'"), HasSubstr("/detections (")));
}

TEST_F(BagScrubbing, RefusesDetectionsOfAnotherType) {
  request.options.detection_topics = {"/words"};

  EXPECT_THAT(test::thrownText<BagError>([&] { scrubBag(request); }),
              HasSubstr("is std_msgs/String, expected geometry_msgs/PoseArray or map_matcher/PersonDetections"));
}

TEST_F(BagScrubbing, RefusesTopicsOfTwoTypes) {
  request.scan_topic = "/scan";
  test::appendToBag(request.bag, "/scan", std_msgs::String());
  EXPECT_THAT(test::thrownText<BagError>([&] { scrubBag(request); }),
              AllOf(HasSubstr("'/scan' of bag '" + request.bag + "'"), HasSubstr("sensor_msgs/LaserScan"),
                    HasSubstr("std_msgs/String")));

  request.scan_topic = "/other_scan";
  test::appendToBag(request.bag, "/other_scan", sensor_msgs::LaserScan());
  test::appendToBag(request.bag, "/detections", std_msgs::String());
  EXPECT_THAT(test::thrownText<BagError>([&] { scrubBag(request); }),
              AllOf(HasSubstr("'/detections' of bag '" + request.bag + "'"), HasSubstr("geometry_msgs/PoseArray"),
                    HasSubstr("std_msgs/String")));
}

TEST_F(BagScrubbing, RefusesToOverwriteTheBagItReads) {
  request.output = request.bag;

  EXPECT_THAT(test::thrownText<BagError>([&] { scrubBag(request); }), HasSubstr("the bag itself"));
}

TEST_F(BagScrubbing, RefusesAnOutputThatCannotBeWritten) {
  request.output = dir / "nowhere/scrubbed.bag";

  EXPECT_THAT(test::thrownText<BagError>([&] { scrubBag(request); }), HasSubstr("cannot be written"));
}

TEST(RecordedPeople, AreGoneFromTheScansTheyWereAnnotatedIn) {
  const auto data = test::dataDir();
  if (!data) {
    GTEST_SKIP() << "no recorded data";
  }
  BagScrubbingRequest request;
  request.bag = (*data / "people/wheelchair_moving_1.bag").string();
  request.options.detection_topics = {"/people_truth"};
  request.people_topic = "/people_truth";
  request.options.mode = "synchronised";

  const PeopleCount people = scrubBag(request).people;

  EXPECT_EQ(people.scans, 106);
  EXPECT_EQ(people.people, 153);
  EXPECT_EQ(people.near, 1078);
  EXPECT_EQ(people.near_left, 0);
  EXPECT_LT(people.others_lost, people.others / 200);
}

}  // namespace
}  // namespace map_matcher::ros_bags
