#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <map_matcher/PersonDetections.h>
#include <nav_msgs/Odometry.h>
#include <ros/serialization.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/simulation/drive_bag.hpp"
#include "support/ascii_map.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_simulation {
namespace {

using test::TemporaryDir;
using test::thrownText;

simulation::DriveOptions smallDriveOptions(std::uint64_t seed) {
  simulation::DriveOptions options;
  options.seed = seed;
  options.duration = 4.0;
  options.rate = 15.0;
  options.lidar.beams = 31;
  options.lidar.range_max = 3.0;  // some rays return nothing
  options.robot.radius = 0.2;
  return options;
}

simulation::Drive driveInRoom(const simulation::DriveOptions& options) {
  const grid::OccupancyGrid room = test::asciiMap({"############",  //
                                                   "#..........#",  //
                                                   "#.......#..#",  //
                                                   "#..........#",  //
                                                   "############"},
                                                  0.7);
  return simulation::simulateDrive(room, options);
}

simulation::Drive smallDrive(std::uint64_t seed = 1) { return driveInRoom(smallDriveOptions(seed)); }

struct Recorded {
  std::string topic;
  std::string type;
  ros::Time stamp;
  std::vector<std::uint8_t> bytes;
};

bool operator==(const Recorded& a, const Recorded& b) {
  return a.topic == b.topic && a.type == b.type && a.stamp == b.stamp && a.bytes == b.bytes;
}

std::vector<Recorded> readBack(const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  std::vector<Recorded> messages;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
    std::vector<std::uint8_t> bytes(instance.size());
    ros::serialization::OStream stream(bytes.data(), instance.size());
    instance.write(stream);
    messages.push_back({instance.getTopic(), instance.getDataType(), instance.getTime(), std::move(bytes)});
  }
  return messages;
}

template <typename Message>
std::vector<Message> messagesOn(const std::string& topic, const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  std::vector<Message> messages;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
    messages.push_back(*instance.instantiate<Message>());
  }
  return messages;
}

class DriveBag : public testing::Test {
 protected:
  void SetUp() override { writeDriveBag(drive_, path_); }

  const simulation::Drive drive_ = smallDrive();
  const TemporaryDir dir_;
  const std::string path_ = dir_ / "drive.bag";
};

TEST_F(DriveBag, holdsFourMessagesOfEveryStepWithRisingStamps) {
  const std::vector<Recorded> messages = readBack(path_);
  std::map<std::string, std::string> types;
  std::map<std::string, std::size_t> counts;
  std::map<std::string, ros::Time> last;
  for (const Recorded& message : messages) {
    types[message.topic] = message.type;
    ++counts[message.topic];
    EXPECT_GT(message.stamp, last[message.topic]) << message.topic;
    last[message.topic] = message.stamp;
  }
  EXPECT_EQ(types, (std::map<std::string, std::string>{{"/ground_truth", "geometry_msgs/PoseStamped"},
                                                       {"/odom", "nav_msgs/Odometry"},
                                                       {"/scan", "sensor_msgs/LaserScan"},
                                                       {"/tf", "tf2_msgs/TFMessage"}}));
  for (const auto& [topic, count] : counts) {
    EXPECT_EQ(count, drive_.steps.size()) << topic;
  }
  EXPECT_EQ(messages.front().stamp, ros::Time(1000.0));
  EXPECT_EQ(messages.back().stamp, ros::Time(1004.002));  // the scan arrives last
}

TEST_F(DriveBag, holdsTheScansAsTheyWereMeasured) {
  const auto scans = messagesOn<sensor_msgs::LaserScan>("/scan", path_);
  ASSERT_EQ(scans.size(), drive_.steps.size());
  bool some_returned_nothing = false;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const scan::PlanarScan& expected = drive_.steps[i].scans.front();
    EXPECT_EQ(scans[i].header.frame_id, "laser");
    EXPECT_EQ(scans[i].header.seq, i);
    EXPECT_EQ(scans[i].ranges, expected.ranges);
    EXPECT_FLOAT_EQ(scans[i].angle_min, static_cast<float>(expected.angle_min));
    EXPECT_FLOAT_EQ(scans[i].angle_max, static_cast<float>(-expected.angle_min));
    EXPECT_FLOAT_EQ(scans[i].angle_increment, static_cast<float>(expected.angle_increment));
    EXPECT_FLOAT_EQ(scans[i].range_max, 3.0F);
    EXPECT_FLOAT_EQ(scans[i].scan_time, 1.0F / 15.0F);
    for (const float range : scans[i].ranges) {
      some_returned_nothing = some_returned_nothing || std::isinf(range);
    }
  }
  EXPECT_TRUE(some_returned_nothing);
}

TEST_F(DriveBag, holdsOdometryAndGroundTruth) {
  const auto odometry = messagesOn<nav_msgs::Odometry>("/odom", path_);
  const auto truth = messagesOn<geometry_msgs::PoseStamped>("/ground_truth", path_);
  ASSERT_EQ(odometry.size(), drive_.steps.size());
  ASSERT_EQ(truth.size(), drive_.steps.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const simulation::DriveStep& step = drive_.steps[i];
    EXPECT_EQ(odometry[i].header.frame_id, "odom");
    EXPECT_EQ(odometry[i].child_frame_id, "base_link");
    EXPECT_EQ(truth[i].header.frame_id, "map");
    EXPECT_EQ(truth[i].header.stamp, odometry[i].header.stamp);
    EXPECT_EQ(odometry[i].twist.twist.linear.x, step.velocity.linear);
    EXPECT_EQ(odometry[i].twist.twist.angular.z, step.velocity.angular);
    const grid::Rigid2 read = ros_common::fromMessage(odometry[i].pose.pose, "odometry");
    const grid::Rigid2 stood = ros_common::fromMessage(truth[i].pose, "truth");
    EXPECT_NEAR(read.x, step.T_odom_base.x, 1e-12);
    EXPECT_NEAR(read.yaw, step.T_odom_base.yaw, 1e-12);
    EXPECT_NEAR(stood.y, step.T_map_base.y, 1e-12);
    EXPECT_NEAR(stood.yaw, step.T_map_base.yaw, 1e-12);
  }
}

/// A mapper that looks the scan's transform up as the scan comes must find it.
TEST_F(DriveBag, tellsTheTransformOfEveryScanBeforeTheScan) {
  tf2::BufferCore buffer;
  rosbag::Bag bag(path_, rosbag::bagmode::Read);
  std::size_t num_scans = 0;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
    if (const auto transforms = instance.instantiate<tf2_msgs::TFMessage>()) {
      for (const geometry_msgs::TransformStamped& transform : transforms->transforms) {
        ASSERT_TRUE(buffer.setTransform(transform, "bag"));
      }
    }
    if (const auto scan = instance.instantiate<sensor_msgs::LaserScan>()) {
      const auto transform = buffer.lookupTransform("odom", scan->header.frame_id, scan->header.stamp);
      const grid::Rigid2 expected = drive_.steps[num_scans].T_odom_base * drive_.T_base_lidar.front();
      const grid::Rigid2 T_odom_laser = ros_common::fromMessage(transform.transform, "T_odom_laser");
      EXPECT_NEAR(T_odom_laser.x, expected.x, 1e-9);
      EXPECT_NEAR(T_odom_laser.y, expected.y, 1e-9);
      EXPECT_NEAR(grid::normalizeAngle(T_odom_laser.yaw - expected.yaw), 0.0, 1e-9);
      ++num_scans;
    }
  }
  EXPECT_EQ(num_scans, drive_.steps.size());
}

TEST_F(DriveBag, isTheSameForTheSameSeedOnly) {
  const std::string again = dir_ / "again.bag";
  const std::string other = dir_ / "other.bag";
  writeDriveBag(smallDrive(1), again);
  writeDriveBag(smallDrive(2), other);
  EXPECT_TRUE(readBack(again) == readBack(path_));
  EXPECT_FALSE(readBack(other) == readBack(path_));
}

TEST_F(DriveBag, takesOtherNamesAndAnotherStart) {
  DriveMessageOptions options;
  options.start_stamp = 50.25;
  options.lidars = {{"/sick_laser_front/scan", "detections", "scored_detections", "sick_laser_front"}};
  options.map_frame = "truth_map";
  const std::string path = dir_ / "named.bag";
  writeDriveBag(drive_, path, options);
  const auto scans = messagesOn<sensor_msgs::LaserScan>("/sick_laser_front/scan", path);
  ASSERT_EQ(scans.size(), drive_.steps.size());
  EXPECT_EQ(scans.front().header.stamp, ros::Time(50.25));
  EXPECT_EQ(scans.front().header.frame_id, "sick_laser_front");
  EXPECT_EQ(messagesOn<tf2_msgs::TFMessage>("/tf", path).front().transforms[1].child_frame_id, "sick_laser_front");
  EXPECT_EQ(messagesOn<geometry_msgs::PoseStamped>("/ground_truth", path).front().header.frame_id, "truth_map");
}

/// Two lidars, four people, and a detector that is late and works through every other scan.
simulation::Drive crowdedDrive() {
  simulation::DriveOptions options = smallDriveOptions(1);
  simulation::equipAsPepper(options);
  options.pedestrians.people = 4;
  options.detector.rate = 8.0;
  options.detector.latency = 0.1;
  return driveInRoom(options);
}

TEST(CrowdedDriveBag, holdsWhereEverybodyIs) {
  const TemporaryDir dir;
  const simulation::Drive drive = crowdedDrive();
  writeDriveBag(drive, dir / "crowd.bag");
  const auto people = messagesOn<geometry_msgs::PoseArray>("/people_truth", dir / "crowd.bag");
  ASSERT_EQ(people.size(), drive.steps.size());
  for (std::size_t i = 0; i < people.size(); ++i) {
    EXPECT_EQ(people[i].header.frame_id, "map");
    ASSERT_EQ(people[i].poses.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      const grid::Rigid2 pose = ros_common::fromMessage(people[i].poses[k], "person");
      EXPECT_NEAR(pose.x, drive.steps[i].people[k].position.x(), 1e-12);
      EXPECT_NEAR(grid::normalizeAngle(pose.yaw - drive.steps[i].people[k].heading), 0.0, 1e-9);
    }
  }
}

TEST(CrowdedDriveBag, holdsTheScansOfBothLidarsWithTheirFrames) {
  const TemporaryDir dir;
  const simulation::Drive drive = crowdedDrive();
  writeDriveBag(drive, dir / "crowd.bag");
  const auto front = messagesOn<sensor_msgs::LaserScan>("/sick_laser_front/scan", dir / "crowd.bag");
  const auto rear = messagesOn<sensor_msgs::LaserScan>("/sick_laser_rear/scan", dir / "crowd.bag");
  ASSERT_EQ(front.size(), drive.steps.size());
  ASSERT_EQ(rear.size(), drive.steps.size());
  EXPECT_EQ(front[3].ranges, drive.steps[3].scans[0].ranges);
  EXPECT_EQ(rear[3].ranges, drive.steps[3].scans[1].ranges);
  EXPECT_EQ(rear[3].header.frame_id, "sick_laser_rear");
  const auto transforms = messagesOn<tf2_msgs::TFMessage>("/tf", dir / "crowd.bag").front().transforms;
  ASSERT_EQ(transforms.size(), 3U);
  EXPECT_EQ(transforms[2].child_frame_id, "sick_laser_rear");
  EXPECT_EQ(transforms[2].transform.translation.x, -0.245);
}

TEST(CrowdedDriveBag, holdsDetectionsAsDrSpaamSendsThem) {
  const TemporaryDir dir;
  const simulation::Drive drive = crowdedDrive();
  writeDriveBag(drive, dir / "crowd.bag");
  for (std::size_t lidar = 0; lidar < 2; ++lidar) {
    const std::string topic = lidar == 0 ? "/dr_spaam_detections/front" : "/dr_spaam_detections/rear";
    rosbag::Bag bag(dir / "crowd.bag", rosbag::bagmode::Read);
    std::size_t num_messages = 0;
    std::size_t num_detections = 0;
    for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
      const auto message = instance.instantiate<geometry_msgs::PoseArray>();
      EXPECT_EQ(message->header.frame_id, lidar == 0 ? "sick_laser_front" : "sick_laser_rear");
      EXPECT_NEAR((instance.getTime() - message->header.stamp).toSec(), 0.1, 1e-6);
      const simulation::DriveStep& step = drive.steps[message->header.seq];
      EXPECT_NEAR(message->header.stamp.toSec(), 1000.0 + step.time, 1e-6);
      std::size_t num_counted = 0;
      for (const simulation::DetectedPerson& detection : step.detections[lidar]->people) {
        num_counted += detection.score >= 0.4 ? 1U : 0U;
      }
      ASSERT_EQ(message->poses.size(), num_counted);
      for (std::size_t k = 0; k < num_counted; ++k) {
        EXPECT_EQ(message->poses[k].position.x, step.detections[lidar]->people[k].position.x());
        EXPECT_EQ(message->poses[k].orientation.w, 0.0);
        EXPECT_EQ(message->poses[k].orientation.z, 0.0);
      }
      num_detections += num_counted;
      ++num_messages;
    }
    EXPECT_EQ(num_messages, (drive.steps.size() + 1) / 2);  // also those with nobody
    EXPECT_GT(num_detections, 10U);
  }
}

/// With scores a detection counts from whatever score its user wants.
TEST(CrowdedDriveBag, holdsEveryDetectionWithItsScore) {
  const TemporaryDir dir;
  const simulation::Drive drive = crowdedDrive();
  writeDriveBag(drive, dir / "crowd.bag");
  for (std::size_t lidar = 0; lidar < 2; ++lidar) {
    const std::string topic = lidar == 0 ? "/person_detections/front" : "/person_detections/rear";
    rosbag::Bag bag(dir / "crowd.bag", rosbag::bagmode::Read);
    std::size_t num_messages = 0;
    std::size_t num_low = 0;
    for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
      const auto message = instance.instantiate<PersonDetections>();
      ASSERT_TRUE(message);
      EXPECT_EQ(message->header.frame_id, lidar == 0 ? "sick_laser_front" : "sick_laser_rear");
      EXPECT_NEAR((instance.getTime() - message->header.stamp).toSec(), 0.1, 1e-6);
      const simulation::DriveStep& step = drive.steps[message->header.seq];
      EXPECT_NEAR(message->header.stamp.toSec(), 1000.0 + step.time, 1e-6);
      const std::vector<simulation::DetectedPerson>& expected = step.detections[lidar]->people;
      ASSERT_EQ(message->detections.size(), expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(message->detections[k].position.x, expected[k].position.x());
        EXPECT_EQ(message->detections[k].position.y, expected[k].position.y());
        EXPECT_EQ(message->detections[k].score, static_cast<float>(expected[k].score));
        num_low += expected[k].score < 0.4 ? 1U : 0U;
      }
      ++num_messages;
    }
    EXPECT_EQ(num_messages, (drive.steps.size() + 1) / 2);
    EXPECT_GT(num_low, 0U);
  }
}

TEST(CrowdedDriveBag, refusesNamesForAnotherNumberOfLidars) {
  const TemporaryDir dir;
  DriveMessageOptions options;
  options.lidars = lidarNames(1);
  const std::string text =
      thrownText<std::invalid_argument>([&] { writeDriveBag(crowdedDrive(), dir / "crowd.bag", options); });
  EXPECT_NE(text.find("names for 1 lidars, expected 2"), std::string::npos) << text;
  EXPECT_EQ(lidarNames(3)[2].scan_topic, "laser_3/scan");
}

TEST_F(DriveBag, thatCannotBeWrittenIsAnErrorThatNamesTheFile) {
  const std::string path = dir_ / "missing/drive.bag";
  const std::string text = thrownText<DriveBagError>([&] { writeDriveBag(drive_, path); });
  EXPECT_NE(text.find(path), std::string::npos) << text;
}

TEST_F(DriveBag, refusesAStartThatIsNoStamp) {
  for (const double stamp : {0.0, -5.0, 1e10, std::nan("")}) {
    DriveMessageOptions options;
    options.start_stamp = stamp;
    const std::string text =
        thrownText<std::invalid_argument>([&] { writeDriveBag(drive_, dir_ / "bad.bag", options); });
    EXPECT_NE(text.find("start_stamp is"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace map_matcher::ros_simulation
